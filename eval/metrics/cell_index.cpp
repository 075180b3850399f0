// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/metrics/cell_index.hpp"

#include <algorithm>
#include <cmath>

namespace ribbon_mapper::eval {

CellIndex::CellIndex(const std::vector<Eigen::Vector2d>& points, double reach_m)
    : reach_m_(reach_m) {
  buckets_.reserve(points.size());
  for (const Eigen::Vector2d& point : points) buckets_[bucket_of(point, 0, 0)].push_back(point);
}

bool CellIndex::has_near(const Eigen::Vector2d& place) const {
  for (const int du : {0, -1, 1}) {
    for (const int dv : {0, -1, 1}) {
      if (bucket_has_near(bucket_of(place, du, dv), place)) return true;
    }
  }
  return false;
}

std::int64_t CellIndex::bucket_of(const Eigen::Vector2d& place, int du, int dv) const {
  constexpr std::int64_t kRow = std::int64_t{1} << 32;
  const auto u = static_cast<std::int64_t>(std::floor(place.x() / reach_m_)) + du;
  const auto v = static_cast<std::int64_t>(std::floor(place.y() / reach_m_)) + dv;
  return v * kRow + u;
}

bool CellIndex::bucket_has_near(std::int64_t bucket, const Eigen::Vector2d& place) const {
  const auto found = buckets_.find(bucket);
  if (found == buckets_.end()) return false;
  return std::any_of(found->second.begin(), found->second.end(), [&](const Eigen::Vector2d& p) {
    return (p - place).squaredNorm() <= reach_m_ * reach_m_;
  });
}

}  // namespace ribbon_mapper::eval
