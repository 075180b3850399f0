// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/scan_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "modeler/geometry/angles.hpp"
#include "modeler/geometry/pose_defect.hpp"

namespace ribbon_mapper {
namespace {

/// No robot travels further while its laser takes one line; without a limit, a jump of odometry
/// makes ribbons of any length.
constexpr double kMaxTravel_m = 100.0;

/// Pads to four doubles, so that the arithmetic maps to whole SSE2 registers.
Eigen::Vector4d padded(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z(), 0.0}; }

/// The laser's motion from the first to the last beam, as a function of the fraction s in
/// -0.5 .. 0.5 about the middle. The rotation is expanded to second order in s: exact to 1e-7 rad
/// for the 0.02 rad that a PR2's tilt turns within a line.
class LaserMotion {
 public:
  LaserMotion(const Pose& T_odom_laser_first, const Pose& T_odom_laser_last)
      : middle_(interpolate(T_odom_laser_first, T_odom_laser_last, 0.5)),
        travel_(T_odom_laser_last.translation() - T_odom_laser_first.translation()) {
    const Eigen::AngleAxisd turn(T_odom_laser_last.linear() *
                                 T_odom_laser_first.linear().transpose());
    const Eigen::Vector3d rotation = turn.angle() * turn.axis();
    for (int i = 0; i < 2; ++i) {
      const Eigen::Vector3d axis = middle_.linear().col(i), moved = rotation.cross(axis);
      axes_[i] = {padded(axis), padded(moved), padded(0.5 * rotation.cross(moved))};
    }
  }

  Eigen::Vector3d origin(double s) const { return middle_.translation() + s * travel_; }
  const Eigen::Vector3d& travel() const { return travel_; }

  /// Returns the direction in odom of `beam`, a direction in the scan plane.
  Eigen::Vector4d direction(double s, const Eigen::Vector2d& beam) const {
    return beam.x() * axes_[0].at(s) + beam.y() * axes_[1].at(s);
  }

 private:
  /// An axis of the scan plane in odom, to second order.
  struct Axis {
    Eigen::Vector4d at_middle, first_order, second_order;
    Eigen::Vector4d at(double s) const { return at_middle + s * (first_order + s * second_order); }
  };

  Pose middle_;
  Eigen::Vector3d travel_;
  std::array<Axis, 2> axes_;
};

/// Generates the beams' directions in the scan plane. Each is the one before, rotated; every 32nd
/// is computed exactly, before rounding accumulates to 1e-14.
class BeamFan {
 public:
  explicit BeamFan(const LaserBeams& beams)
      : beams_(beams),
        turn_(std::cos(beams.angle_increment_rad), std::sin(beams.angle_increment_rad)) {}

  Eigen::Vector2d next() {
    if (index_ % kTurns == 0) {
      const double angle_rad =
          beams_.angle_min_rad + static_cast<double>(index_) * beams_.angle_increment_rad;
      beam_ = {std::cos(angle_rad), std::sin(angle_rad)};
    } else {
      beam_ = {turn_.x() * beam_.x() - turn_.y() * beam_.y(),
               turn_.y() * beam_.x() + turn_.x() * beam_.y()};
    }
    ++index_;
    return beam_;
  }

 private:
  static constexpr std::size_t kTurns = 32;

  const LaserBeams& beams_;
  Eigen::Vector2d turn_, beam_{1.0, 0.0};
  std::size_t index_ = 0;
};

void resize(ScanLine& line, std::size_t size) {
  line.ranges_m.resize(size);
  line.directions.resize(size);
  line.points.resize(size);
  line.first_of_segment.resize(size);
  line.end_of_segment.resize(size);
  line.before.resize(size + 1);
}

// Between two beams of one surface lie at most so many standard deviations of a range, or, at a
// grazing view of 7 degrees, so many spacings of the beams.
constexpr double kMaxSigmas = 6.0, kMaxSpacings = 8.0;

/// Returns true if a beam and the one before it lie further apart than noise and a grazing view
/// explain.
bool is_jump(const ScanLine& line, std::size_t beam, const ScanConfig& config) {
  const double spacing = line.ranges_m[beam] * std::abs(line.angle_increment_rad);
  const double limit = std::max(kMaxSigmas * config.range_sigma_m, kMaxSpacings * spacing);
  return (line.points[beam] - line.points[beam - 1]).squaredNorm() > limit * limit;
}

void find_segments(ScanLine& line, const ScanConfig& config) {
  const std::size_t size = line.size();
  for (std::size_t begin = 0; begin < size;) {
    std::size_t end = begin + 1;
    if (line.has_return(begin)) {
      while (end < size && line.has_return(end) && !is_jump(line, end, config)) ++end;
    }
    for (std::size_t i = begin; i < end; ++i) {
      line.first_of_segment[i] = static_cast<std::uint32_t>(begin);
      line.end_of_segment[i] = static_cast<std::uint32_t>(end);
    }
    begin = end;
  }
}

/// The column about the base that holds the robot itself.
class RobotBody {
 public:
  RobotBody(const ScanLine& line, const ScanConfig& config)
      : half_m_(config.body_height_m > 0.0 ? config.body_half_size_m : 0.0),
        height_m_(config.body_height_m),
        T_base_odom_(line.T_odom_base.inverse(Eigen::Isometry)) {}

  bool holds(const Eigen::Vector3d& point) const {
    return std::abs(in_base(0, point)) < half_m_ && std::abs(in_base(1, point)) < half_m_ &&
           in_base(2, point) < height_m_;
  }

 private:
  double in_base(int axis, const Eigen::Vector3d& point) const {
    return T_base_odom_(axis, 0) * point.x() + T_base_odom_(axis, 1) * point.y() +
           T_base_odom_(axis, 2) * point.z() + T_base_odom_(axis, 3);
  }

  double half_m_, height_m_;
  Pose T_base_odom_;
};

/// The limits between which ranges are returns.
class ReturnLimits {
 public:
  ReturnLimits(const LaserBeams& beams, const ScanConfig& config)
      : min_m_(std::max(beams.range_min_m, config.min_range_m)),
        max_m_(std::min(beams.range_max_m, config.max_range_m)) {}

  /// Returns false for NaN, and for infinity whatever the limits.
  bool hold(float range_m) const {
    return range_m >= min_m_ && range_m <= max_m_ && range_m <= std::numeric_limits<float>::max();
  }

 private:
  double min_m_, max_m_;
};

/// Returns true if the middle one of three neighbouring ranges is a mixed pixel. The steps are
/// tested first: few are large, so the branch is predictable.
inline bool is_mixed_pixel(const float* r, const ReturnLimits& limits, double step_per_range) {
  const double before = r[-1], range = r[0], after = r[1];
  const double to_it = range - before, from_it = after - range;
  return std::abs(to_it) > step_per_range * std::min(before, range) &&
         std::abs(from_it) > step_per_range * std::min(range, after) && to_it * from_it > 0.0 &&
         limits.hold(r[-1]) && limits.hold(r[1]);
}

/// Copies the ranges of the returns and sets all others to 0.
void take_returns(const LaserBeams& beams, const ScanConfig& config, ScanLine& line) {
  const ReturnLimits limits(beams, config);
  const double mixed_pixel_step = mixed_pixel_step_per_range(beams, config);
  const float* ranges_m = beams.ranges_m.data();
  const std::size_t size = line.size();
  for (std::size_t i = 0; i < size; ++i) {
    const bool inner = i > 0 && i + 1 < size;
    const bool lost = !limits.hold(ranges_m[i]) ||
                      (inner && is_mixed_pixel(ranges_m + i, limits, mixed_pixel_step));
    line.ranges_m[i] = lost ? 0.0F : ranges_m[i];
  }
}

void place_returns(const LaserBeams& beams, const LaserMotion& motion, const ScanConfig& config,
                   ScanLine& line) {
  const RobotBody body(line, config);
  const std::size_t size = line.size();
  const double step = config.deskew && size > 1 ? 1.0 / static_cast<double>(size - 1) : 0.0;
  const double first = config.deskew ? -0.5 : 0.0;
  line.first_origin = motion.origin(first);
  line.origin_step = step * motion.travel();
  const Eigen::Vector4d origin = padded(line.first_origin), to_next = padded(line.origin_step);
  BeamFan fan(beams);
  for (std::size_t i = 0; i < size; ++i) {
    const auto beam = static_cast<double>(i);
    const Eigen::Vector4d direction = motion.direction(first + beam * step, fan.next());
    const Eigen::Vector4d point = origin + beam * to_next + line.ranges_m[i] * direction;
    line.directions[i] = direction.head<3>();
    line.points[i] = point.head<3>();
    if (body.holds(line.points[i])) line.ranges_m[i] = 0.0F;
  }
}

void sum_up(ScanLine& line) {
  Moments sum;
  for (std::size_t i = 0; i < line.size(); ++i) {
    line.before[i] = sum;
    if (line.has_return(i)) sum.add(line.points[i]);
  }
  line.before[line.size()] = sum;
}

}  // namespace

double mixed_pixel_step_per_range(const LaserBeams& beams, const ScanConfig& config) {
  if (config.mixed_pixel_angle_deg <= 0.0) return std::numeric_limits<double>::infinity();
  return std::sin(std::abs(beams.angle_increment_rad)) /
         std::tan(config.mixed_pixel_angle_deg * kDegree);
}

bool is_mixed_pixel(const LaserBeams& beams, std::size_t beam, const ScanConfig& config,
                    double step_per_range) {
  return beam > 0 && beam + 1 < beams.ranges_m.size() &&
         is_mixed_pixel(beams.ranges_m.data() + beam, ReturnLimits(beams, config), step_per_range);
}

bool is_return(float range_m, const LaserBeams& beams, const ScanConfig& config) {
  return ReturnLimits(beams, config).hold(range_m);
}

std::optional<std::string> find_defect(const LaserBeams& beams, const LinePoses& poses) {
  if (!std::isfinite(beams.angle_min_rad) || !std::isfinite(beams.angle_increment_rad) ||
      beams.angle_increment_rad == 0.0) {
    return "angles are not finite, or angle_increment is 0";
  }
  if (!std::isfinite(beams.time_increment_s)) return "time_increment is not finite";
  if (!(beams.range_min_m >= 0.0) || !(beams.range_max_m > beams.range_min_m)) {
    return "range_min and range_max are not 0 <= range_min < range_max";
  }
  const auto count = static_cast<double>(beams.ranges_m.size());
  if (count * std::abs(beams.angle_increment_rad) > 2.0 * M_PI + 0.1) {
    return "more ranges than angle_increment allows for one rotation";
  }
  for (const Pose* pose :
       {&poses.T_odom_base_first, &poses.T_odom_base_last, &poses.T_base_laser_first,
        &poses.T_base_laser_last, &poses.T_map_base}) {
    if (const auto defect = find_defect(*pose)) return "a pose " + *defect;
  }
  const Eigen::Vector3d travel =
      poses.T_odom_base_last.translation() - poses.T_odom_base_first.translation();
  if (travel.norm() > kMaxTravel_m) return "odometry jumps by more than 100 m within the line";
  return std::nullopt;
}

void place_beams(const LaserBeams& beams, const LinePoses& poses, const ScanConfig& config,
                 ScanLine& line) {
  const LaserMotion motion(poses.T_odom_base_first * poses.T_base_laser_first,
                           poses.T_odom_base_last * poses.T_base_laser_last);
  line.stamp = middle_of(beams);
  line.T_map_base = poses.T_map_base;
  line.T_odom_base = interpolate(poses.T_odom_base_first, poses.T_odom_base_last, 0.5);
  line.half_increment_sine = std::sin(0.5 * std::abs(beams.angle_increment_rad));
  line.first_angle_rad = beams.angle_min_rad;
  line.angle_increment_rad = beams.angle_increment_rad;
  line.averaged_lines = 1;
  line.beams = beams;
  line.poses = poses;
  resize(line, beams.ranges_m.size());
  take_returns(beams, config, line);
  place_returns(beams, motion, config, line);
  sum_up(line);
  find_segments(line, config);
}

}  // namespace ribbon_mapper
