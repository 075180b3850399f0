// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "modeler/floor_plan/floor_plan_config.hpp"
#include "modeler/floor_plan/intervals.hpp"
#include "modeler/polygon/polygon.hpp"
#include "modeler/semantics/semantics.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// One side of a wall, seen from above at one height: a line, and where on it the wall was seen.
struct WallFace {
  std::int64_t plane = 0;                             ///< id of the plane
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< towards the side it was seen from
  double distance_m = 0.0;                            ///< normal . p of all its points
  Intervals seen;                                     ///< where it stands, along `along()`
  Intervals open;                                     ///< where one can walk through
  Intervals solid;                                    ///< where most of the band was seen
  double cell_m = 0.0;                                ///< side of the plane's cells

  /// Returns the direction of the line.
  Eigen::Vector2d along() const { return {-normal.y(), normal.x()}; }
  /// Returns the point at a position along the line, in map [m].
  Eigen::Vector2d at(double along_m) const { return distance_m * normal + along_m * along(); }
  /// Returns the position of a point along the line [m].
  double along_m(const Eigen::Vector2d& point) const { return along().dot(point); }
  /// Returns how far a point is behind the face [m]: negative on the side it was seen from.
  double depth_m(const Eigen::Vector2d& point) const { return distance_m - normal.dot(point); }
};

/// Returns the floor seen from above: the outlines of planes that are floor or a ramp, united.
Polygons floor_of(const std::vector<Plane>& planes, const Semantics& semantics);

/// Returns the height of the largest floor, or of the lowest foot of a wall if there is none; 0 for
/// a model without both [m].
double floor_height_m(const std::vector<Plane>& planes, const Semantics& semantics);

/// Returns the faces of all upright walls above `floor`, which is that of floor_of(), cut 1 m above
/// the floor: the height at which plans are cut (ISO 128).
///
/// A face stands where its outlines are, at any height. Where it hangs above the band of the
/// configuration and the floor goes on below it, it is open.
std::vector<WallFace> wall_faces(const std::vector<Plane>& planes, const Semantics& semantics,
                                 const Polygons& floor, const FloorPlanConfig& config);

/// Moves the ends of faces that nearly meet in a corner into it. An end moves by up to
/// FloorPlanConfig::joint_m, and by up to overshoot_m if it lies before the other face, where
/// nothing is. Where there are several corners, it moves into the nearest one.
void fit_corners(std::vector<WallFace>& faces, const FloorPlanConfig& config);

}  // namespace ribbon_mapper
