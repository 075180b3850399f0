// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/tour/ground_profile.hpp"

#include <algorithm>
#include <cmath>

#include "sim/robot/pr2.hpp"

namespace ribbon_mapper::sim {

using pr2::kCasters_m;

GroundProfile::GroundProfile(std::vector<double> ways_m, std::vector<double> heights_m)
    : ways_m_(std::move(ways_m)), heights_m_(std::move(heights_m)) {}

bool GroundProfile::is_level() const {
  return std::all_of(heights_m_.begin(), heights_m_.end(), [](double h) { return h == 0.0; });
}

double GroundProfile::height_m(double way_m) const {
  if (ways_m_.empty()) return 0.0;
  const auto after = std::upper_bound(ways_m_.begin(), ways_m_.end(), way_m);
  if (after == ways_m_.begin()) return heights_m_.front();
  if (after == ways_m_.end()) return heights_m_.back();
  const auto i = static_cast<std::size_t>(after - ways_m_.begin());
  const double share = (way_m - ways_m_[i - 1]) / (ways_m_[i] - ways_m_[i - 1]);
  return heights_m_[i - 1] + share * (heights_m_[i] - heights_m_[i - 1]);
}

Pose GroundProfile::T_level_base(double way_m) const {
  const double front_m = height_m(way_m + kCasters_m), rear_m = height_m(way_m - kCasters_m);
  const double pitch_rad = -std::atan2(front_m - rear_m, 2.0 * kCasters_m);  // positive looks down
  return Eigen::Translation3d(0.0, 0.0, (front_m + rear_m) / 2.0) *
         Pose(Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()));
}

bool GroundProfile::is_level_at(double way_m) const {
  const double here_m = height_m(way_m);
  return std::abs(height_m(way_m + kCasters_m) - here_m) < 1e-9 &&
         std::abs(height_m(way_m - kCasters_m) - here_m) < 1e-9;
}

}  // namespace ribbon_mapper::sim
