// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/orientation_grid.hpp"

#include <algorithm>
#include <cmath>

namespace ribbon_mapper {

OrientationGrid::OrientationGrid(double cell_deg) {
  // An odd number of rows, so that the poles are the centres of their rows.
  const auto rows = std::max<std::size_t>(1, std::llround(180.0 / cell_deg)) + 1;
  row_height_rad_ = M_PI / static_cast<double>(rows - 1);
  std::size_t cells = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    first_cell_.push_back(cells);
    const double circumference = 2.0 * M_PI * std::sin(static_cast<double>(row) * row_height_rad_);
    cells += std::max<std::size_t>(1, std::llround(circumference / row_height_rad_));
  }
  first_cell_.push_back(cells);
  votes_.assign(cells, 0.0);
  normals_.assign(cells, Eigen::Vector3d::Zero());
}

std::size_t OrientationGrid::cell_of(const Eigen::Vector3d& normal) const {
  const double polar = std::acos(std::clamp(normal.z(), -1.0, 1.0));
  const auto row = static_cast<std::size_t>(std::llround(polar / row_height_rad_));
  const std::size_t cells = first_cell_[row + 1] - first_cell_[row];
  const double turn = std::atan2(normal.y(), normal.x()) / (2.0 * M_PI) + 0.5;
  return first_cell_[row] + std::min(cells - 1, static_cast<std::size_t>(turn * cells));
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
