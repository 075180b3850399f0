// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace ribbon_mapper::eval {

/// Answers in constant time whether any of many points in the plane lies near a place.
class CellIndex {
 public:
  /// `reach_m`: how near is near.
  CellIndex(const std::vector<Eigen::Vector2d>& points, double reach_m);
  bool has_near(const Eigen::Vector2d& place) const;

 private:
  std::int64_t bucket_of(const Eigen::Vector2d& place, int du, int dv) const;
  bool bucket_has_near(std::int64_t bucket, const Eigen::Vector2d& place) const;

  double reach_m_;
  std::unordered_map<std::int64_t, std::vector<Eigen::Vector2d>> buckets_;  // as wide as the reach
};

}  // namespace ribbon_mapper::eval
