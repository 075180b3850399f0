// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/scan_front_end.hpp"

#include <cmath>
#include <utility>

#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {
namespace {

/// Largest distance of the robot from the origin along an axis [m]. At five times as much, sums of
/// squares change a plane's area by 2 %; their error grows with the square of the distance.
constexpr double kMaxDistance_m = 100.0;
/// Origins are multiples of this power of two [m], so that subtracting them rounds nothing.
constexpr double kOriginStep_m = 64.0;

/// A session that goes on later than this after the last one has not the same odometry for sure.
constexpr Time kLongestPause = std::chrono::seconds(1);

/// Returns the poses with those in odom relative to `origin`.
LinePoses relative_to(const Eigen::Vector3d& origin, LinePoses poses) {
  poses.T_odom_base_first.translation() -= origin;
  poses.T_odom_base_last.translation() -= origin;
  return poses;
}

}  // namespace

const char* to_string(LineResult result) {
  switch (result) {
    case LineResult::modelled:
      return "modelled";
    case LineResult::waiting:
      return "waiting for neighbours";
    case LineResult::no_ribbons:
      return "no ribbons";
    case LineResult::too_close:
      return "too close";
    case LineResult::no_returns:
      return "no returns";
    case LineResult::malformed:
      return "malformed";
    case LineResult::out_of_order:
      return "out of order";
  }
  return "unknown";
}

ScanFrontEnd::ScanFrontEnd(const ScanConfig& config, Parts parts)
    : config_(config),
      last_stamp_(parts.last_stamp),
      is_resumed_(false),
      no_returns_(config, std::move(parts.no_returns)),
      buffer_(config.base_line_sigmas * config.range_sigma_m),
      averager_(config, std::move(parts.average)),
      odom_origin_(parts.odom_origin) {
  std::size_t done = 0;
  for (std::size_t i = 0; i < parts.lines.size(); ++i) {
    const Parts::Line& source = parts.lines[i];
    ScanLine& line = buffer_.incoming();
    line.odom_origin = odom_origin_;
    place_beams(source.beams, source.poses, config_, line);
    line.averaged_lines = source.averaged_lines;
    if (!line.has_returns()) continue;  // the limits of ranges have changed
    buffer_.push();
    if (i < parts.done) ++done;
  }
  buffer_.set_done(done);
  is_resumed_ = buffer_.newest_line() != nullptr;
}

ScanFrontEnd::Parts ScanFrontEnd::parts() const {
  Parts parts;
  parts.last_stamp = last_stamp_;
  parts.odom_origin = odom_origin_;
  for (std::size_t i = 0; i < buffer_.size(); ++i) {
    const ScanLine& line = buffer_.line(i);
    parts.lines.push_back({line.beams, line.poses, line.averaged_lines});
  }
  parts.done = buffer_.done();
  if (averager_.lines() > 0) parts.average = averager_.sums();
  parts.no_returns = no_returns_.evidence();
  return parts;
}

LineResult ScanFrontEnd::add(const LaserBeams& raw_beams, const LinePoses& poses_in_odom) {
  if (find_defect(raw_beams, poses_in_odom)) return LineResult::malformed;
  const LaserBeams& beams = no_returns_.filter(raw_beams);
  ScanLine& line = buffer_.incoming();
  line.odom_origin = odom_origin_for(poses_in_odom);
  const LinePoses poses = relative_to(line.odom_origin, poses_in_odom);
  place_beams(beams, poses, config_, line);
  if (!line.has_returns()) return LineResult::no_returns;
  if (!is_in_order(line)) return LineResult::out_of_order;
  forget_after_pause(line.stamp);
  if (line.odom_origin != odom_origin_) {
    buffer_.clear();
    odom_origin_ = line.odom_origin;
  } else if (buffer_.newest_line() && !has_moved(line) && !replace_by_average(line, beams, poses)) {
    return LineResult::too_close;
  }
  averager_.clear();
  buffer_.push();
  return LineResult::waiting;
}

/// Returns the present origin, or one near the robot if that is too far from it.
Eigen::Vector3d ScanFrontEnd::odom_origin_for(const LinePoses& poses) const {
  const Eigen::Vector3d base = poses.T_odom_base_first.translation();
  if ((base - odom_origin_).cwiseAbs().maxCoeff() <= kMaxDistance_m) return odom_origin_;
  return kOriginStep_m * (base / kOriginStep_m).array().round();
}

/// Returns the stamp of the newest line that was kept. Needs one.
Time ScanFrontEnd::newest_stamp() const {
  return averager_.lines() > 0 ? averager_.last_stamp() : buffer_.newest_line()->stamp;
}

bool ScanFrontEnd::is_in_order(const ScanLine& line) const {
  if (buffer_.newest_line()) return line.stamp > newest_stamp();
  return !last_stamp_ || line.stamp > *last_stamp_;
}

/// Forgets lines of an earlier session if it did not end just before the first one of this session.
void ScanFrontEnd::forget_after_pause(Time stamp) {
  if (!std::exchange(is_resumed_, false) || stamp - newest_stamp() <= kLongestPause) return;
  averager_.clear();
  buffer_.clear();
}

/// Returns true if the line's beams lie beyond the noise from those of the newest line.
bool ScanFrontEnd::has_moved(const ScanLine& line) const {
  const double step_m = config_.line_step_sigmas * config_.range_sigma_m;
  const double noise_factor = std::sqrt(static_cast<double>(line.averaged_lines));
  return base_line_m(*buffer_.newest_line(), line) >= step_m / noise_factor;
}

/// Adds the beams to the average. Replaces `line` by the average and returns true if that has
/// moved.
bool ScanFrontEnd::replace_by_average(ScanLine& line, const LaserBeams& beams,
                                      const LinePoses& poses) {
  averager_.add(beams, poses);
  if (averager_.lines() < LineAverager::kMinLines) return false;
  place_beams(averager_.average_beams(), averager_.mean_poses(), config_, line);
  line.averaged_lines = averager_.lines();
  return has_moved(line);
}

}  // namespace ribbon_mapper
