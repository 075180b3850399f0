// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "modeler/ros/offline/offline_run.hpp"

namespace ribbon_mapper {

/// Returns a page to look at a model of a recording, see Report.
std::string offline_page(const OfflineRun& run, const std::string& run_id);

}  // namespace ribbon_mapper
