// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/line_averaging.hpp"

#include <cmath>
#include <limits>

#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {
namespace {

/// Largest number of lines in an average; more occur only where the tilt stands still.
constexpr std::size_t kMaxLines = 16;

/// Ranges further than this from the mean belong to another surface.
constexpr double kSameSurfaceSigmas = 6.0;

bool has_same_beams(const LaserBeams& a, const LaserBeams& b) {
  return a.ranges_m.size() == b.ranges_m.size() && a.angle_min_rad == b.angle_min_rad &&
         a.angle_increment_rad == b.angle_increment_rad && a.time_increment_s == b.time_increment_s;
}

}  // namespace

void LineAverager::add(const LaserBeams& beams, const LinePoses& poses) {
  if (lines_ == kMaxLines || (lines_ > 0 && !has_same_beams(beams, beams_))) lines_ = 0;
  if (lines_++ == 0) {
    start(beams, poses);
  } else {
    approach(beams, poses);
  }
  last_stamp_ = middle_of(beams);
  add_ranges(beams);
}

void LineAverager::start(const LaserBeams& beams, const LinePoses& poses) {
  beams_ = beams;
  poses_ = poses;
  sums_m_.assign(beams.ranges_m.size(), 0.0F);
  agreeing_.assign(beams.ranges_m.size(), 0);
  returns_.assign(beams.ranges_m.size(), 0);
}

/// Moves the mean stamp and the mean poses by the new line's share.
void LineAverager::approach(const LaserBeams& beams, const LinePoses& poses) {
  const double share = 1.0 / static_cast<double>(lines_);
  beams_.stamp += from_seconds(share * to_seconds(beams.stamp - beams_.stamp));
  for (Pose LinePoses::*pose :
       {&LinePoses::T_odom_base_first, &LinePoses::T_odom_base_last, &LinePoses::T_base_laser_first,
        &LinePoses::T_base_laser_last, &LinePoses::T_map_base}) {
    poses_.*pose = interpolate(poses_.*pose, poses.*pose, share);
  }
}

void LineAverager::add_ranges(const LaserBeams& beams) {
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

const LaserBeams& LineAverager::average_beams() {
  for (std::size_t i = 0; i < sums_m_.size(); ++i) {
    beams_.ranges_m[i] = 2U * agreeing_[i] > returns_[i] ? sums_m_[i] / agreeing_[i]
                                                         : std::numeric_limits<float>::infinity();
  }
  return beams_;
}

}  // namespace ribbon_mapper
