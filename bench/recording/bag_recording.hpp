// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "bench/recording/recording.hpp"
#include "modeler/ros/bag/bag_lines.hpp"

namespace ribbon_mapper::bench {

/// The lines of a bag for which tf has poses, as the node would take them. There is no truth: the
/// recorded poses are taken for final. Throws std::runtime_error that names the bag as BagLines
/// does, and if it has hardly a line with poses.
Recording recording_of_bag(const std::filesystem::path& file, const BagOptions& options);

}  // namespace ribbon_mapper::bench
