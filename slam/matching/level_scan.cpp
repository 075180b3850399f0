// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/matching/level_scan.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/geometry/square.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr std::size_t kMaxReach = 12;  // beams on each side of a normal; near walls have many

struct Placed {
  double x = 0.0, y = 0.0;
  double step_m = 0.0;  // to the next beam on a wall that is seen at a right angle
};

bool is_return(double range_m, const LaserBeams& beams, const LevelScanConfig& config) {
  return std::isfinite(range_m) && range_m >= beams.range_min_m && range_m > 0.0 &&
         range_m < beams.range_max_m && range_m <= config.max_range_m;
}

std::vector<Placed> placed(const LaserBeams& beams, const Pose& T_base_laser,
                           const PlanarPose& T_first_last, const LevelScanConfig& config) {
  std::vector<Placed> points;
  points.reserve(beams.ranges_m.size());
  const double last = std::max(1.0, static_cast<double>(beams.ranges_m.size()) - 1.0);
  for (std::size_t i = 0; i < beams.ranges_m.size(); ++i) {
    const double range_m = beams.ranges_m[i];
    if (!is_return(range_m, beams, config)) continue;
    const double angle = beams.angle_min_rad + static_cast<double>(i) * beams.angle_increment_rad;
    const Eigen::Vector3d p =
        T_base_laser * Eigen::Vector3d(range_m * std::cos(angle), range_m * std::sin(angle), 0.0);
    const double part = static_cast<double>(i) / last;
    const double yaw = part * T_first_last.yaw_rad, c = std::cos(yaw), s = std::sin(yaw);
    points.push_back({part * T_first_last.x_m + c * p.x() - s * p.y(),
                      part * T_first_last.y_m + s * p.x() + c * p.y(),
                      range_m * std::abs(beams.angle_increment_rad)});
  }
  return points;
}

double square_distance(const Placed& a, const Placed& b) {
  return square(a.x - b.x) + square(a.y - b.y);
}

/// Returns how far the surface of a point goes on, counted in points towards `step`.
std::size_t reach(const std::vector<Placed>& points, std::size_t at, int step, double radius_m) {
  constexpr double kGrazing = 6.0;  // beams that hit a wall at 10 degrees are so much farther apart
  std::size_t count = 0;
  for (std::size_t i = at; count < kMaxReach; ++count) {
    if (step < 0 ? i == 0 : i + 1 == points.size()) break;
    const std::size_t next = step < 0 ? i - 1 : i + 1;
    const double gap_m = 0.05 + kGrazing * points[i].step_m;
    if (square_distance(points[i], points[next]) > square(gap_m)) break;
    if (square_distance(points[at], points[next]) > square(radius_m) && count >= 2) break;
    i = next;
  }
  return count;
}

/// The points of the surface around one: so many before it, and so many after it.
struct Surroundings {
  std::size_t before = 0, after = 0;
};

Surroundings surroundings_of(const std::vector<Placed>& points, std::size_t at,
                             const LevelScanConfig& config) {
  return {reach(points, at, -1, config.normal_radius_m),
          reach(points, at, 1, config.normal_radius_m)};
}

/// Returns how many points on the next one is that is kept, by the mean distance of the points
/// around one. The first that is far enough would be one whose range errs in the direction of the
/// sweep: surfaces ahead would turn against those behind.
std::size_t stride(const std::vector<Placed>& points, std::size_t at, const Surroundings& around,
                   const LevelScanConfig& config) {
  const std::size_t steps = around.before + around.after;
  if (steps == 0) return 1;
  const double way_m =
      std::sqrt(square_distance(points[at - around.before], points[at + around.after]));
  const double wanted = config.spacing_m * static_cast<double>(steps) / std::max(way_m, 1e-3);
  return static_cast<std::size_t>(std::clamp(std::ceil(wanted), 1.0, 2.0 * kMaxReach));
}

/// Sets the normal of a point by the line through its neighbours, if they lie on one.
void set_normal(const std::vector<Placed>& points, std::size_t at, const Surroundings& around,
                const Eigen::Vector2d& laser, const LevelScanConfig& config, LevelPoint& point) {
  const auto [before, after] = around;
  const double n = static_cast<double>(before + after + 1);
  if (n < 3.0) return;
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = at - before; i <= at + after; ++i) {
    const double dx = points[i].x - points[at].x, dy = points[i].y - points[at].y;
    x += dx, y += dy, xx += dx * dx, xy += dx * dy, yy += dy * dy;
  }
  xx = xx / n - square(x / n), yy = yy / n - square(y / n), xy = xy / n - x * y / (n * n);
  const double half = 0.5 * std::hypot(xx - yy, 2.0 * xy), mean = 0.5 * (xx + yy);
  const double least = std::max(0.0, mean - half), most = mean + half;
  if (least > square(config.max_bend_m) || least > 0.15 * most) return;
  const double along = 0.5 * std::atan2(2.0 * xy, xx - yy);
  double nx = -std::sin(along), ny = std::cos(along);
  if (nx * (laser.x() - points[at].x) + ny * (laser.y() - points[at].y) < 0.0) nx = -nx, ny = -ny;
  point.normal_x = static_cast<float>(nx), point.normal_y = static_cast<float>(ny);
}

}  // namespace

bool is_level(const Pose& T_base_laser, const LevelScanConfig& config) {
  return std::abs(T_base_laser(2, 2)) >= std::cos(config.max_tilt_rad);
}

LevelScan level_scan_of(const LaserBeams& beams, const Pose& T_base_laser,
                        const PlanarPose& T_first_last, const LevelScanConfig& config) {
  LevelScan scan;
  scan.stamp = beams.stamp;
  const std::vector<Placed> points = placed(beams, T_base_laser, T_first_last, config);
  const Eigen::Vector2d laser = T_base_laser.translation().head<2>();
  for (std::size_t i = 0; i < points.size();) {
    LevelPoint point{static_cast<float>(points[i].x), static_cast<float>(points[i].y)};
    const Surroundings around = surroundings_of(points, i, config);
    set_normal(points, i, around, laser, config, point);
    scan.points.push_back(point);
    i += stride(points, i, around, config);
  }
  return scan;
}

void append_moved(const LevelPoints& points, const PlanarPose& T_target_source,
                  LevelPoints& moved_points) {
  const double c = std::cos(T_target_source.yaw_rad), s = std::sin(T_target_source.yaw_rad);
  for (const LevelPoint& point : points)
    moved_points.push_back(moved(point, T_target_source, c, s));
}

}  // namespace ribbon_mapper::slam
