// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace ribbon_mapper::eval {

/// Contingency table of two segmentations: the number of points that each true region shares with
/// each estimated one.
class Overlaps {
 public:
  /// Index that stands for points outside all regions.
  static constexpr int kNoRegion = -1;

  /// Creates a table of `truth` true and `estimates` estimated regions without points.
  Overlaps(std::size_t truth, std::size_t estimates);

  /// Adds points that lie in the true region `truth` and in the estimated region `estimate`. Either
  /// may be kNoRegion.
  void add(int truth, int estimate, std::size_t points = 1);

  /// Returns the number of true regions.
  std::size_t truth() const { return truth_points_.size(); }

  /// Returns the number of estimated regions.
  std::size_t estimates() const { return estimated_points_.size(); }

  /// Returns the number of points that both regions contain.
  std::size_t shared(std::size_t truth, std::size_t estimate) const {
    return shared_[truth * estimates() + estimate];
  }

  /// Returns the number of points in a true region.
  std::size_t truth_points(std::size_t truth) const { return truth_points_[truth]; }

  /// Returns the share of the true region's points that lie in the estimate; 0 for empty regions.
  double share_of_truth(std::size_t truth, std::size_t estimate) const;

  /// Returns the share of the estimate's points that lie in the true region; 0 for empty regions.
  double share_of_estimate(std::size_t truth, std::size_t estimate) const;

  /// Returns the intersection over union of both regions; 0 for empty regions.
  double iou(std::size_t truth, std::size_t estimate) const;

 private:
  std::vector<std::size_t> shared_, truth_points_, estimated_points_;
};

}  // namespace ribbon_mapper::eval
