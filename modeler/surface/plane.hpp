// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ribbon_mapper {

/// A seen cell of a plane's grid (section 6 of the paper).
struct PlaneCell {
  std::int32_t u = 0;        ///< column: covers [u, u+1) * cell size along `axis_u` from `origin`
  std::int32_t v = 0;        ///< row: covers [v, v+1) * cell size along `axis_v` from `origin`
  std::uint32_t count = 0;   ///< number of points in the cell
  float mean_m = 0.0F;       ///< mean signed distance of these points from the plane
  float variance_m2 = 0.0F;  ///< variance of this distance
};

/// An area with holes on a plane.
struct Outline {
  std::vector<Eigen::Vector3d> outer;               ///< counter-clockwise about the normal
  std::vector<std::vector<Eigen::Vector3d>> holes;  ///< clockwise
};

/// A bounded plane of the model, n.p + d = 0, in the map frame.
///
/// The centre of cell (u, v) is origin + (u + 0.5) * s * axis_u + (v + 0.5) * s * axis_v, with the
/// cell size s.
struct Plane {
  /// Identifier. It persists over corrections as long as most of the plane does.
  std::int64_t id = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< n, points to the side it was seen from
  double d_m = 0.0;                                   ///< d
  double area_m2 = 0.0;  ///< number of seen cells times the area of one cell
  /// Ribbons of the plane: ascending indices into Modeler::ribbons().
  std::vector<std::uint32_t> ribbons;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< mean of the seen cells' centres
  /// Covariance of (rotation about axis_u [rad], rotation about axis_v [rad], offset at the
  /// centroid [m]).
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  double cell_size_m = 0.05;                          ///< side of a cell
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();   ///< corner (0, 0) of the grid, on the plane
  Eigen::Vector3d axis_u = Eigen::Vector3d::UnitX();  ///< direction of columns; horizontal on walls
  Eigen::Vector3d axis_v = Eigen::Vector3d::UnitY();  ///< direction of rows: normal x axis_u
  std::vector<PlaneCell> cells;                       ///< seen cells only, sorted by (v, u)

  /// Boundaries of what was seen, on the plane. The first point of each is not repeated.
  std::vector<Outline> outlines;
};

/// Returns for each of `count` ribbons the index of its plane, or -1.
std::vector<std::int32_t> planes_by_ribbon(std::size_t count, const std::vector<Plane>& planes);

/// Returns the centre of a cell in the map frame, on the plane.
inline Eigen::Vector3d cell_centre(const Plane& plane, const PlaneCell& cell) {
  return plane.origin + (cell.u + 0.5) * plane.cell_size_m * plane.axis_u +
         (cell.v + 0.5) * plane.cell_size_m * plane.axis_v;
}

/// Returns the lower left corner of cell (u, v) in the map frame, on the plane.
inline Eigen::Vector3d grid_corner(const Plane& plane, int u, int v) {
  return plane.origin + u * plane.cell_size_m * plane.axis_u + v * plane.cell_size_m * plane.axis_v;
}

/// A rectangle of cells, aligned with the axes of the grid.
struct CellRectangle {
  std::int32_t u_begin = 0;  ///< first column
  std::int32_t u_end = 0;    ///< one past the last column
  std::int32_t v_begin = 0;  ///< first row
  std::int32_t v_end = 0;    ///< one past the last row
};

/// Returns the smallest rectangle around the cells of a plane.
CellRectangle bounds_of_cells(const Plane& plane);

/// Returns the box around that rectangle, in the frame of the plane; empty without cells.
Eigen::AlignedBox3d box_of_cells(const Plane& plane);
/// Returns box_of_cells() of each plane.
std::vector<Eigen::AlignedBox3d> boxes_of_cells(const std::vector<Plane>& planes);

/// Returns the surface of a plane as few rectangles that do not overlap, for meshes and markers.
/// Closes stripes between scan lines of up to `stripe_gap_m`; see SurfaceConfig::stripe_gap_m.
std::vector<CellRectangle> surface_rectangles(const Plane& plane, double stripe_gap_m);

}  // namespace ribbon_mapper
