// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/semantics/plane_shape.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "modeler/geometry/angles.hpp"
#include "modeler/geometry/grid_keys.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kEdgeShare = 0.1;  // of stray cells beyond an edge

Attitude attitude_of(double tilt_deg, const LabelConfig& config) {
  if (tilt_deg <= config.level_deg) return Attitude::level_up;
  if (tilt_deg >= 180.0 - config.level_deg) return Attitude::level_down;
  if (std::abs(tilt_deg - 90.0) <= config.upright_deg) return Attitude::upright;
  return tilt_deg < 90.0 ? Attitude::tilted_up : Attitude::tilted_down;
}

Eigen::Vector2d level_direction(const Plane& plane) {
  const Eigen::Vector2d across(-plane.normal.y(), plane.normal.x());
  return across.norm() > 1e-6 ? across.normalized() : Eigen::Vector2d::UnitX();
}

std::vector<Column> columns_of(const Plane& plane, const Eigen::Vector2d& along) {
  std::map<std::int32_t, Column> columns;
  for (const PlaneCell& cell : plane.cells) {
    const Eigen::Vector3d centre = cell_centre(plane, cell);
    const double along_m = along.dot(centre.head<2>());
    Column& column = columns[floor_to_int(along_m / plane.cell_size_m)];
    column.place += centre.head<2>();
    column.along_m += along_m;
    column.heights_m.push_back(centre.z());
  }
  std::vector<Column> sorted;
  for (auto& [number, column] : columns) {
    column.place /= static_cast<double>(column.heights_m.size());
    column.along_m /= static_cast<double>(column.heights_m.size());
    std::sort(column.heights_m.begin(), column.heights_m.end());
    sorted.push_back(std::move(column));
  }
  return sorted;
}

/// Sets the edges of an upright plane by its columns.
void set_edges(const Plane& plane, PlaneShape& shape) {
  std::vector<double> bottoms, tops;
  for (const Column& column : shape.columns) {
    bottoms.push_back(column.heights_m.front());
    tops.push_back(column.heights_m.back());
  }
  const double half_m = 0.5 * plane.cell_size_m;
  shape.lowest_m = value_at(bottoms, kEdgeShare) - half_m;
  shape.highest_m = value_at(tops, 1.0 - kEdgeShare) + half_m;
  shape.begin_m = shape.columns.front().along_m - half_m;
  shape.end_m = shape.columns.back().along_m + half_m;
}

void set_edges_of_area(const Plane& plane, PlaneShape& shape) {
  std::vector<double> heights, along;
  for (const PlaneCell& cell : plane.cells) {
    const Eigen::Vector3d centre = cell_centre(plane, cell);
    heights.push_back(centre.z());
    along.push_back(shape.along.dot(centre.head<2>()));
  }
  shape.lowest_m = value_at(heights, 0.02);
  shape.highest_m = value_at(heights, 0.98);
  shape.begin_m = value_at(along, 0.0);
  shape.end_m = value_at(along, 1.0);
}

}  // namespace

double value_at(std::vector<double> values, double share) {
  const auto rank =
      static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

PlaneShape shape_of(const Plane& plane, const LabelConfig& config) {
  PlaneShape shape;
  shape.tilt_deg = to_degrees(std::acos(std::clamp(plane.normal.z(), -1.0, 1.0)));
  shape.tilt_sigma_deg = to_degrees(
      std::sqrt(std::max(0.0, std::max(plane.covariance(0, 0), plane.covariance(1, 1)))));
  shape.attitude = attitude_of(shape.tilt_deg, config);
  shape.along = level_direction(plane);
  if (plane.cells.empty()) return shape;
  if (shape.attitude == Attitude::upright) {
    shape.columns = columns_of(plane, shape.along);
    set_edges(plane, shape);
  } else {
    set_edges_of_area(plane, shape);
  }
  return shape;
}

}  // namespace ribbon_mapper
