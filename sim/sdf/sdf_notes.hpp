// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

namespace ribbon_mapper::sim {

/// What was left out of an SDF file, and what its author should know.
struct SdfNotes {
  std::map<std::string, std::size_t> left_out;  ///< number of elements that no laser sees, by name
  std::set<std::string> visual_only;            ///< models without any collision
  std::size_t renamed = 0;                      ///< elements whose name another one has already
  std::set<std::string> warnings;               ///< anything else
};

}  // namespace ribbon_mapper::sim
