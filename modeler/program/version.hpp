// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace ribbon_mapper {

/// Returns the version of the package, with the commit that it was configured at if known.
std::string version();

}  // namespace ribbon_mapper
