// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace ribbon_mapper {

/// Votes by area over the orientations of section 4.2 (360 x 180 degrees). On a plain grid of
/// azimuth and elevation the cells shrink to nothing at the poles, which is where floor and ceiling
/// lie; here each row has as many cells as its circumference holds, so all have about the same
/// solid angle, and one cell caps each pole.
class OrientationGrid {
 public:
  explicit OrientationGrid(double cell_deg);

  std::size_t cell_count() const { return votes_.size(); }
  std::size_t cell_of(const Eigen::Vector3d& unit_normal) const;

  /// Returns the cell, by which the vote can be withdrawn.
  std::size_t vote(const Eigen::Vector3d& unit_normal, double area_m2);
  void withdraw(std::size_t cell, const Eigen::Vector3d& unit_normal, double area_m2);
  void clear();

  struct Peak {
    Eigen::Vector3d normal;  ///< area-weighted mean of the cell's votes, unit length
    double area_m2;
  };
  /// The cell with the largest area; area 0 if there are no votes.
  Peak peak() const;

 private:
  std::vector<std::size_t> first_cell_;  // of each row, and the number of all cells at the end
  double rows_per_turn_;
  std::vector<double> votes_;
  std::vector<Eigen::Vector3d> normals_;  // area-weighted sums
  std::vector<std::size_t> touched_;      // cells that may hold votes
};

}  // namespace ribbon_mapper
