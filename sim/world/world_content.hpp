// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "sim/sdf/sdf_reader.hpp"
#include "sim/shapes/tessellation.hpp"

namespace ribbon_mapper::sim {

/// Returns the box around all bounded faces [m, map], empty if there are none. Throws
/// std::runtime_error that names the world if no room has such a size: a world in millimetres.
Eigen::AlignedBox3d plausible_extent(const std::string& path, const Tessellation& tessellation);

/// Returns what was loaded and what was left out, for the user, in one line.
std::string content_text(const SdfShapes& sdf, const Eigen::AlignedBox3d& extent_m);

/// Returns the warnings as lines.
std::vector<std::string> warning_texts(const SdfNotes& notes, const Eigen::AlignedBox3d& extent_m);

}  // namespace ribbon_mapper::sim
