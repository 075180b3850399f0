// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace ribbon_mapper {

/// Votes by area over the orientations of section 4.2 of the paper (360 x 180 degrees).
///
/// On a plain grid of azimuth and elevation, cells shrink to nothing at the poles, where the
/// normals of floor and ceiling lie. Here each row has as many cells as fit its circumference, so
/// that all cells have about the same solid angle. One cell caps each pole.
class OrientationGrid {
 public:
  /// Creates a grid without votes, with cells about `cell_deg` wide [deg].
  explicit OrientationGrid(double cell_deg);

  /// Returns the number of cells.
  std::size_t cell_count() const { return votes_.size(); }
  /// Returns the index of the cell that holds a unit normal.
  std::size_t cell_of(const Eigen::Vector3d& unit_normal) const;

  /// Adds a vote and returns the index of its cell, with which it can be withdrawn.
  std::size_t vote(const Eigen::Vector3d& unit_normal, double area_m2);
  /// Withdraws a vote from the cell that vote() returned.
  void withdraw(std::size_t cell, const Eigen::Vector3d& unit_normal, double area_m2);
  /// Removes all votes.
  void clear();

  /// The cell with the largest area.
  struct Peak {
    Eigen::Vector3d normal;  ///< area-weighted mean of the cell's votes, unit length
    double area_m2;          ///< sum of the areas of the cell's votes; 0 if there are none
  };
  /// Returns the cell with the largest area.
  Peak peak() const;

 private:
  std::vector<std::size_t> first_cell_;  // of each row, and the number of all cells at the end
  double rows_per_turn_;
  std::vector<double> votes_;
  std::vector<Eigen::Vector3d> normals_;  // area-weighted sums
  std::vector<std::size_t> touched_;      // cells that may hold votes
};

}  // namespace ribbon_mapper
