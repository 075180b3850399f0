// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/floor_plan/floor_plan_config.hpp"
#include "modeler/floor_plan/wall_face.hpp"

namespace ribbon_mapper {

/// A piece of wall between two faces.
struct FacePair {
  std::size_t front = 0;  ///< index of the first face
  std::size_t back = 0;   ///< index of the second face, behind it
  Interval piece;         ///< along the first face [m]
};

/// Faces in pairs, and what is left of them.
struct FacePairs {
  std::vector<FacePair> pairs;      ///< by index of the first face, then of the second one
  std::vector<Intervals> unpaired;  ///< pieces of each face
};

/// Returns the pieces in which two faces are one wall, as plan_walls() says it.
FacePairs pairs_of(const std::vector<WallFace>& faces, const FloorPlanConfig& config);

/// Returns a piece of one face as a piece of another one that is nearly parallel.
Interval on_face(const WallFace& to, const WallFace& from, const Interval& piece);

}  // namespace ribbon_mapper
