// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace ribbon_mapper::eval {

/// Index of 2D points that answers radius queries in constant time.
class CellIndex {
 public:
  /// Indexes `points` for queries of radius `reach_m`.
  CellIndex(const std::vector<Eigen::Vector2d>& points, double reach_m);

  /// Returns true if a point lies within the radius of `place`.
  bool has_near(const Eigen::Vector2d& place) const;

 private:
  std::int64_t bucket_of(const Eigen::Vector2d& place, int du, int dv) const;
  bool bucket_has_near(std::int64_t bucket, const Eigen::Vector2d& place) const;

  double reach_m_;
  std::unordered_map<std::int64_t, std::vector<Eigen::Vector2d>> buckets_;  // of side reach_m_
};

}  // namespace ribbon_mapper::eval
