// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sim/sdf/sdf_notes.hpp"
#include "sim/shapes/shape.hpp"

namespace ribbon_mapper::sim {

/// The shapes of an SDF file.
struct SdfShapes {
  std::vector<Shape> shapes;  ///< posed in the world's frame
  SdfNotes notes;             ///< what is not among them
};

/// Reads all collisions of an SDF file as seen_sdf() sees it, where its <state> places them. Throws
/// std::runtime_error that names the file and says what to do, also if there is no collision.
SdfShapes read_sdf(const std::string& path, const std::vector<std::string>& model_paths,
                   bool visuals);

}  // namespace ribbon_mapper::sim
