// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace ribbon_mapper {

/// A cell of a plane's grid: what the beams saw there (section 6 of the paper).
struct PlaneCell {
  std::int32_t u = 0;        ///< column: covers [u, u+1) * cell size along `axis_u` from `origin`
  std::int32_t v = 0;        ///< row, likewise along `axis_v`
  std::uint32_t count = 0;   ///< points perceived in the cell
  float mean_m = 0.0F;       ///< mean signed distance of these points from the plane
  float variance_m2 = 0.0F;  ///< variance of that distance
};

/// A bounded plane of the model, in the map frame: n.p + d = 0, n towards the side it was seen
/// from.
struct Plane {
  std::int64_t id = 0;  ///< stays the same over corrections, as long as most of the plane does
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double d_m = 0.0;
  double area_m2 = 0.0;  ///< number of seen cells times the area of one
  /// That it is made of: indices into Modeler::ribbons(), sorted.
  std::vector<std::uint32_t> ribbons;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< mean of the seen cells, on the plane
  /// Covariance of (rotation about axis_u [rad], rotation about axis_v [rad], offset at the
  /// centroid [m]).
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  // The grid: cell (u, v) is centred on origin + (u + 0.5) * s * axis_u + (v + 0.5) * s * axis_v.
  double cell_size_m = 0.05;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_u = Eigen::Vector3d::UnitX();  ///< axis_u x axis_v = normal
  Eigen::Vector3d axis_v = Eigen::Vector3d::UnitY();
  std::vector<PlaneCell> cells;  ///< seen cells only, sorted by (v, u)

  /// Outer boundary, counter-clockwise about the normal, not closed, on the plane.
  std::vector<Eigen::Vector3d> outline;
};

/// Centre of a cell in the map frame, on the plane.
inline Eigen::Vector3d cell_centre(const Plane& plane, const PlaneCell& cell) {
  return plane.origin + (cell.u + 0.5) * plane.cell_size_m * plane.axis_u +
         (cell.v + 0.5) * plane.cell_size_m * plane.axis_v;
}

/// A corner of the grid in the map frame.
inline Eigen::Vector3d grid_corner(const Plane& plane, int u, int v) {
  return plane.origin + u * plane.cell_size_m * plane.axis_u + v * plane.cell_size_m * plane.axis_v;
}

/// Axis-aligned rectangle of cells [u_begin, u_end) x [v_begin, v_end).
struct CellRectangle {
  std::int32_t u_begin = 0, u_end = 0, v_begin = 0, v_end = 0;
};

/// The surface of the plane as few rectangles of cells that do not overlap; the stripes between
/// scan lines are closed where they are at most `closing_m` wide. For meshes and markers.
std::vector<CellRectangle> surface_rectangles(const Plane& plane, double closing_m = 0.3);

}  // namespace ribbon_mapper
