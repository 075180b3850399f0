// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/orientation_grid.hpp"

#include <algorithm>
#include <cmath>

namespace ribbon_mapper {
namespace {

/// Returns atan2(y, x) / 2 pi to 2e-6 (Abramowitz and Stegun 4.4.49). The borders of cells need no
/// more, and the library's function takes as long as the rest of a vote.
double turn_of(double y, double x) {
  const double smaller = std::min(std::abs(x), std::abs(y));
  const double larger = std::max(std::abs(x), std::abs(y));
  const double ratio = larger > 0.0 ? smaller / larger : 0.0, square = ratio * ratio;
  double angle =
      ratio *
      (0.9998660 +
       square * (-0.3302995 + square * (0.1801410 + square * (-0.0851330 + square * 0.0208351))));
  if (std::abs(y) > std::abs(x)) angle = M_PI_2 - angle;
  if (x < 0.0) angle = M_PI - angle;
  return (y < 0.0 ? -angle : angle) / (2.0 * M_PI);
}

}  // namespace

OrientationGrid::OrientationGrid(double cell_deg) {
  // An odd number of rows, so that the poles are the centres of their rows.
  const auto rows = std::max<std::size_t>(1, std::llround(180.0 / cell_deg)) + 1;
  rows_per_turn_ = 2.0 * static_cast<double>(rows - 1);
  const double row_height_rad = 2.0 * M_PI / rows_per_turn_;
  std::size_t cells = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    first_cell_.push_back(cells);
    const double circumference = 2.0 * M_PI * std::sin(static_cast<double>(row) * row_height_rad);
    cells += std::max<std::size_t>(1, std::llround(circumference / row_height_rad));
  }
  first_cell_.push_back(cells);
  votes_.assign(cells, 0.0);
  normals_.assign(cells, Eigen::Vector3d::Zero());
}

std::size_t OrientationGrid::cell_of(const Eigen::Vector3d& normal) const {
  const double sine = std::sqrt(std::max(0.0, 1.0 - normal.z() * normal.z()));
  // Not lround(), which takes as long as the rest; the number is never negative.
  // NOLINTNEXTLINE(bugprone-incorrect-roundings)
  const auto row = static_cast<std::size_t>(turn_of(sine, normal.z()) * rows_per_turn_ + 0.5);
  const std::size_t cells = first_cell_[row + 1] - first_cell_[row];
  const double turn = turn_of(normal.y(), normal.x()) + 0.5;
  return first_cell_[row] +
         std::min(cells - 1, static_cast<std::size_t>(turn * static_cast<double>(cells)));
}

std::size_t OrientationGrid::vote(const Eigen::Vector3d& normal, double area_m2) {
  const std::size_t cell = cell_of(normal);
  if (votes_[cell] == 0.0) touched_.push_back(cell);
  votes_[cell] += area_m2;
  normals_[cell] += area_m2 * normal;
  return cell;
}

void OrientationGrid::withdraw(std::size_t cell, const Eigen::Vector3d& normal, double area_m2) {
  votes_[cell] -= area_m2;
  normals_[cell] -= area_m2 * normal;
}

void OrientationGrid::clear() {
  for (const std::size_t cell : touched_) {
    votes_[cell] = 0.0;
    normals_[cell].setZero();
  }
  touched_.clear();
}

OrientationGrid::Peak OrientationGrid::peak() const {
  std::size_t best = 0;
  double area_m2 = 0.0;
  for (const std::size_t cell : touched_) {
    if (votes_[cell] > area_m2 || (votes_[cell] == area_m2 && cell < best)) {
      best = cell;
      area_m2 = votes_[cell];
    }
  }
  if (area_m2 <= 0.0) return {Eigen::Vector3d::UnitZ(), 0.0};
  return {normals_[best].normalized(), area_m2};
}

}  // namespace ribbon_mapper
