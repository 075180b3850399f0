// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/floor_plan/floor_plan_config.hpp"
#include "modeler/floor_plan/wall_face.hpp"

namespace ribbon_mapper {

/// A door leaf, seen from above.
struct PlanLeaf {
  std::int64_t plane = 0;                           ///< id of the plane
  Eigen::Vector2d hinge = Eigen::Vector2d::Zero();  ///< where it hangs, in map [m]
  Eigen::Vector2d tip = Eigen::Vector2d::Zero();    ///< its other edge, in map [m]
};

/// A door or another opening through a wall, seen from above.
struct PlanOpening {
  /// Ids of the walls that it is in, and of its reveals.
  std::vector<std::int64_t> planes;
  /// Ends of the sill in the middle of the wall, or on the face if one face was seen; in map [m].
  std::array<Eigen::Vector2d, 2> jambs = {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< across the wall, to the first side
  std::optional<double> depth_m;                      ///< thickness of the wall, if it is known
  double sill_m = 0.0;                                ///< height of the floor in it
  std::optional<double> head_m;                       ///< height of the lintel, if it was seen
  std::vector<PlanLeaf> leaves;                       ///< at most one at each jamb
  std::vector<std::size_t> rooms;                     ///< indices of the rooms beside it

  /// Returns true for a door: a lintel or a leaf was seen. Otherwise, the wall is open to the
  /// ceiling, or nobody has seen that it is not.
  bool is_door() const { return head_m || !leaves.empty(); }
  /// Returns the middle.
  Eigen::Vector2d middle() const { return 0.5 * (jambs[0] + jambs[1]); }
};

/// Returns the openings in walls, each once though both faces may show it: those of `semantics` and
/// those that are wider than a door, with their leaves.
///
/// A reveal, the inside of an opening, says where a jamb is. It is removed from `faces`. What lies
/// in an opening is removed from the faces beside it.
std::vector<PlanOpening> plan_openings(const std::vector<Plane>& planes, const Semantics& semantics,
                                       std::vector<WallFace>& faces, const FloorPlanConfig& config);

/// Hangs each door leaf at the jamb that is nearest to one of its edges. Of the two faces of a
/// leaf, the wider one is kept.
void hang_leaves(const std::vector<Plane>& planes, const Semantics& semantics,
                 const FloorPlanConfig& config, std::vector<PlanOpening>& openings);

}  // namespace ribbon_mapper
