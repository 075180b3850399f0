// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/line_averaging.hpp"

#include <cmath>
#include <limits>

#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {
namespace {

constexpr std::size_t kMaxLines = 16;  // a tilt that stands still, or nearly so
/// Ranges further than this from the mean of those before are of another surface.
constexpr double kSameSurfaceSigmas = 6.0;

bool same_beams(const LaserBeams& a, const LaserBeams& b) {
  return a.ranges_m.size() == b.ranges_m.size() && a.angle_min_rad == b.angle_min_rad &&
         a.angle_increment_rad == b.angle_increment_rad && a.time_increment_s == b.time_increment_s;
}

}  // namespace

void LineAverager::add(const LaserBeams& beams, const LinePoses& poses) {
  if (lines_ == kMaxLines || (lines_ > 0 && !same_beams(beams, beams_))) lines_ = 0;
  if (lines_++ == 0) {
    beams_ = beams;
    poses_ = poses;
    sums_m_.assign(beams.ranges_m.size(), 0.0F);
    agreeing_.assign(beams.ranges_m.size(), 0);
    returns_.assign(beams.ranges_m.size(), 0);
  } else {
    const double share = 1.0 / static_cast<double>(lines_);
    const auto approach = [share](Pose& mean, const Pose& pose) {
      mean = interpolate(mean, pose, share);
    };
    beams_.stamp += from_seconds(share * to_seconds(beams.stamp - beams_.stamp));
    approach(poses_.T_odom_base_first, poses.T_odom_base_first);
    approach(poses_.T_odom_base_last, poses.T_odom_base_last);
    approach(poses_.T_base_laser_first, poses.T_base_laser_first);
    approach(poses_.T_base_laser_last, poses.T_base_laser_last);
    approach(poses_.T_map_base, poses.T_map_base);
  }
  last_stamp_ = middle_of(beams);
  const double limit_m = kSameSurfaceSigmas * config_.range_sigma_m;
  for (std::size_t i = 0; i < beams.ranges_m.size(); ++i) {
    const float range_m = beams.ranges_m[i];
    if (!is_return(range_m, beams, config_)) continue;
    ++returns_[i];
    if (agreeing_[i] > 0 && std::abs(range_m - sums_m_[i] / agreeing_[i]) > limit_m) continue;
    sums_m_[i] += range_m;
    ++agreeing_[i];
  }
}

const LaserBeams& LineAverager::beams() {
  for (std::size_t i = 0; i < sums_m_.size(); ++i) {
    beams_.ranges_m[i] = 2u * agreeing_[i] > returns_[i] ? sums_m_[i] / agreeing_[i]
                                                         : std::numeric_limits<float>::infinity();
  }
  return beams_;
}

}  // namespace ribbon_mapper
