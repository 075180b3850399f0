// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "test/slam/matching/wall_world.hpp"

#include <cmath>
#include <limits>

namespace ribbon_mapper::slam {
namespace {

void add_box(double left, double bottom, double right, double top, std::vector<Wall>& walls) {
  walls.push_back({left, bottom, right, bottom});
  walls.push_back({right, bottom, right, top});
  walls.push_back({right, top, left, top});
  walls.push_back({left, top, left, bottom});
}

}  // namespace

WallWorld WallWorld::room() {
  std::vector<Wall> walls;
  add_box(-4.0, -2.5, 4.0, 2.5, walls);
  add_box(1.5, 1.5, 2.7, 2.5, walls);
  return WallWorld(walls);
}

WallWorld WallWorld::square() {
  std::vector<Wall> walls;
  add_box(-3.0, -3.0, 3.0, 3.0, walls);
  return WallWorld(walls);
}

WallWorld WallWorld::corridor() {
  return WallWorld({{-500.0, -1.0, 500.0, -1.0}, {-500.0, 1.0, 500.0, 1.0}});
}

WallWorld WallWorld::ring() {
  std::vector<Wall> walls;
  add_box(-9.0, -7.0, 9.0, 7.0, walls);
  add_box(-7.0, -5.0, 7.0, 5.0, walls);
  for (const double x : {-5.5, -3.2, -0.4, 1.1, 4.7}) add_box(x, -7.0, x + 0.4, -6.7, walls);
  for (const double x : {-6.1, -2.0, 2.9, 3.8}) add_box(x, 6.6, x + 0.5, 7.0, walls);
  for (const double y : {-2.7, 0.9, 2.2}) add_box(8.7, y, 9.0, y + 0.6, walls);
  for (const double y : {-3.4, -1.5, 3.0}) add_box(-9.0, y, -8.6, y + 0.3, walls);
  return WallWorld(walls);
}

double WallWorld::range_m(double x_m, double y_m, double angle_rad) const {
  const double dx = std::cos(angle_rad), dy = std::sin(angle_rad);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Wall& w : walls_) {
    const double ex = w.x2 - w.x1, ey = w.y2 - w.y1, cross = dx * ey - dy * ex;
    if (std::abs(cross) < 1e-12) continue;
    const double range = ((w.x1 - x_m) * ey - (w.y1 - y_m) * ex) / cross;
    const double along = ((w.x1 - x_m) * dy - (w.y1 - y_m) * dx) / cross;
    if (range > 0.0 && along >= 0.0 && along <= 1.0 && range < nearest) nearest = range;
  }
  return nearest;
}

LaserBeams WallWorld::beams(const PlanarPose& T_world_laser, bool is_whole) const {
  LaserBeams beams;
  const double half = is_whole ? M_PI : 0.5 * M_PI, step = M_PI / 180.0;
  beams.angle_min_rad = -half, beams.angle_increment_rad = step;
  beams.range_min_m = 0.05, beams.range_max_m = 60.0;
  const int count = static_cast<int>(std::lround(2.0 * half / step));
  for (int i = 0; i < count; ++i) {
    beams.ranges_m.push_back(static_cast<float>(
        range_m(T_world_laser.x_m, T_world_laser.y_m, T_world_laser.yaw_rad - half + i * step)));
  }
  return beams;
}

LevelScan WallWorld::scan(const PlanarPose& T_world_base, double stamp_s, bool is_whole) const {
  LaserBeams seen = beams(T_world_base, is_whole);
  seen.stamp = from_seconds(stamp_s);
  return level_scan_of(seen, Pose::Identity(), {}, LevelScanConfig());
}

std::vector<PlanarPose> ring_drive(double laps, double step_m) {
  std::vector<PlanarPose> poses;
  const double width = 16.0, height = 12.0, around = 2.0 * (width + height), corner = 1.0;
  for (double way = 0.0; way < laps * around; way += step_m) {
    double at = std::fmod(way, around);
    const double sides[] = {width, height, width, height};
    PlanarPose T_world_side{-8.0, -6.0, 0.0};
    int side = 0;
    while (at >= sides[side]) {
      T_world_side = T_world_side * PlanarPose{sides[side], 0.0, M_PI / 2.0};
      at -= sides[side++];
    }
    // it turns while it drives the last metre of a side
    const double turn = std::max(0.0, at - (sides[side] - corner)) / corner;
    poses.push_back(T_world_side * PlanarPose{at, 0.0, turn * M_PI / 2.0});
  }
  return poses;
}

std::vector<PlanarPose> drifting(const std::vector<PlanarPose>& poses, double longer,
                                 double turn_rad_per_m) {
  std::vector<PlanarPose> drifted{poses.front()};
  for (std::size_t i = 1; i < poses.size(); ++i) {
    PlanarPose step = relative(poses[i - 1], poses[i]);
    const double way = step.translation().norm();
    step.x_m *= 1.0 + longer, step.y_m *= 1.0 + longer;
    step.yaw_rad += turn_rad_per_m * way;
    drifted.push_back(drifted.back() * step);
  }
  return drifted;
}

}  // namespace ribbon_mapper::slam
