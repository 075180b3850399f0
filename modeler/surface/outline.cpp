// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/surface/outline.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/surface/cell_bitmap.hpp"

namespace ribbon_mapper {
namespace {

using Corners = std::vector<GridCorner>;
constexpr double kToleranceInCells = 1.0;

/// Returns the distance of p from the line through a and b.
double distance_from_chord(const GridCorner& p, const GridCorner& a, const GridCorner& b) {
  const double du = b.u - a.u, dv = b.v - a.v, length = std::hypot(du, dv);
  if (length == 0.0) return std::hypot(p.u - a.u, p.v - a.v);
  return std::abs(du * (p.v - a.v) - dv * (p.u - a.u)) / length;
}

/// Appends the corners between `first` and `last`, both excluded, that the algorithm of Douglas and
/// Peucker (1973) keeps.
void simplify(const Corners& corners, std::size_t first, std::size_t last, Corners& kept) {
  double farthest = 0.0;
  std::size_t split = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double distance = distance_from_chord(corners[i], corners[first], corners[last]);
    if (distance > farthest) farthest = distance, split = i;
  }
  if (farthest <= kToleranceInCells) return;
  simplify(corners, first, split, kept);
  kept.push_back(corners[split]);
  simplify(corners, split, last, kept);
}

/// Returns a closed boundary without the corners that matter less than a cell.
Corners simplify(Corners corners) {
  if (corners.size() < 4) return corners;
  const auto before = [](const GridCorner& a, const GridCorner& b) {
    return a.u + a.v != b.u + b.v ? a.u + a.v < b.u + b.v : a.u < b.u;
  };
  // Starts at two opposite corners, which every simplified outline has.
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), before),
              corners.end());
  const auto opposite = std::max_element(corners.begin(), corners.end(), before);
  const auto middle = static_cast<std::size_t>(opposite - corners.begin());
  corners.push_back(corners.front());
  Corners kept{corners.front()};
  simplify(corners, 0, middle, kept);
  kept.push_back(corners[middle]);
  simplify(corners, middle, corners.size() - 1, kept);
  if (kept.size() > 2) return kept;
  corners.pop_back();  // too narrow to be simplified
  return corners;
}

}  // namespace

std::vector<Eigen::Vector3d> outline_of(const Plane& plane, double bridged_gap_m) {
  if (plane.cells.empty()) return {};
  CellBitmap bitmap(plane.cells,
                    static_cast<int>(std::ceil(0.5 * bridged_gap_m / plane.cell_size_m)));
  bitmap.close();
  std::vector<Eigen::Vector3d> outline;
  for (const GridCorner& corner : simplify(bitmap.outer_boundary())) {
    outline.push_back(grid_corner(plane, corner.u, corner.v));
  }
  return outline;
}

}  // namespace ribbon_mapper
