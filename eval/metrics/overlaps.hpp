// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace ribbon_mapper::eval {

/// How many points true regions and estimated ones have in common: all that metrics of a
/// segmentation need to know.
class Overlaps {
 public:
  static constexpr int no_region = -1;

  Overlaps(std::size_t truth, std::size_t estimates);

  /// Points of the true region `truth` in the estimated region `estimate`; either may be no_region.
  void add(int truth, int estimate, std::size_t points = 1);

  std::size_t truth() const { return truth_points_.size(); }          ///< number of true regions
  std::size_t estimates() const { return estimated_points_.size(); }  ///< of estimated ones
  std::size_t shared(std::size_t truth, std::size_t estimate) const {
    return shared_[truth * estimates() + estimate];
  }
  std::size_t truth_points(std::size_t truth) const { return truth_points_[truth]; }
  std::size_t estimated_points(std::size_t estimate) const { return estimated_points_[estimate]; }

  // 0 where there are no points.
  double share_of_truth(std::size_t truth, std::size_t estimate) const;
  double share_of_estimate(std::size_t truth, std::size_t estimate) const;
  double iou(std::size_t truth, std::size_t estimate) const;  ///< intersection over union

 private:
  std::vector<std::size_t> shared_, truth_points_, estimated_points_;
};

}  // namespace ribbon_mapper::eval
