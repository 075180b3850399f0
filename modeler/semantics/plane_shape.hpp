// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "modeler/semantics/label_config.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// How a plane stands.
enum class Attitude {
  level_up,     ///< level, seen from above
  level_down,   ///< level, seen from below
  tilted_up,    ///< neither level nor upright, seen from above
  tilted_down,  ///< neither level nor upright, seen from below
  upright       ///< seen from the side
};

/// The cells of an upright plane above one place.
struct Column {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< mean of the cells, seen from above [m]
  double along_m = 0.0;                             ///< position along PlaneShape::along
  std::vector<double> heights_m;                    ///< of the cells' centres, ascending
};

/// What the rules ask about a plane.
struct PlaneShape {
  Attitude attitude = Attitude::level_up;  ///< how it stands
  double tilt_deg = 0.0;                   ///< angle between its normal and straight up
  double tilt_sigma_deg = 0.0;             ///< standard deviation of `tilt_deg`
  double lowest_m = 0.0;                   ///< height of its lower edge; a tenth is lower still
  double highest_m = 0.0;                  ///< height of its upper edge; a tenth is higher still
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();  ///< level direction on it, seen from above
  double begin_m = 0.0;                              ///< where it begins along `along`
  double end_m = 0.0;                                ///< where it ends along `along`
  std::vector<Column> columns;                       ///< of an upright plane, in this order
};

/// Returns the shape of a plane. One without cells has no columns.
PlaneShape shape_of(const Plane& plane, const LabelConfig& config);

/// Returns the value below which `share` of the values lie. There must be one.
double value_at(std::vector<double> values, double share);

}  // namespace ribbon_mapper
