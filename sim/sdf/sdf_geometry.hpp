// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "sim/sdf/sdf_file.hpp"

namespace ribbon_mapper::sim {

/// Returns the path of the file that a URI refers to, empty if there is none.
using FindFile = std::function<std::string(const std::string& uri)>;

/// Copies the shape of a <geometry> into the element `to`, with the path of its mesh. Returns false
/// if it has none. Throws std::runtime_error as SdfScope::fail() for what no laser could see as it
/// stands: another shape, a missing, unknown or repeated element, a number out of range, a mesh
/// that is not found.
bool copy_geometry(const tinyxml2::XMLElement& geometry, tinyxml2::XMLElement& to,
                   const SdfScope& scope, const FindFile& find_mesh);

/// Copies the <pose> of an element into `to`, if it has one. Throws as SdfScope::fail().
void copy_pose(const tinyxml2::XMLElement& from, tinyxml2::XMLElement& to, const SdfScope& scope);

/// Lengths and coordinates [m] that are read; a world is checked for plausible ones when complete.
constexpr NumberRange kLength_m{1e-6, 1e6}, kCoordinate_m{-1e6, 1e6};

}  // namespace ribbon_mapper::sim
