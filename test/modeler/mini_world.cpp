// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "test/modeler/mini_world.hpp"

#include <cmath>
#include <limits>
#include <random>

namespace ribbon_mapper::mini_world {
namespace {

constexpr double kLinePeriod_s = 0.025, kScanTime_s = 0.0185;

Pose T_map_laser(const Motion& motion, double time_s) {
  return motion.T_map_base(time_s) * T_base_laser(motion.tilt_rad(time_s));
}

/// Returns the beams of a line that begins at `first_s`.
LaserBeams measured_beams(const World& world, const Motion& motion, double first_s,
                          std::size_t count, const std::function<double()>& noise_m) {
  LaserBeams beams;
  beams.stamp = from_seconds(1000.0 + first_s);
  beams.angle_min_rad = -M_PI_2;
  beams.angle_increment_rad = M_PI / (count - 1.0);
  beams.time_increment_s = kScanTime_s / (count - 1.0);
  beams.range_min_m = 0.1;
  beams.range_max_m = 30.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Pose pose = T_map_laser(motion, first_s + i * beams.time_increment_s);
    const double angle = beams.angle_min_rad + i * beams.angle_increment_rad;
    const Eigen::Vector3d beam(std::cos(angle), std::sin(angle), 0.0);
    const double range = range_m(world, pose.translation(), pose.linear() * beam);
    beams.ranges_m.push_back(static_cast<float>(range + noise_m()));
  }
  return beams;
}

}  // namespace

Face plane(const Eigen::Vector3d& normal, double d_m) {
  return plane(normal, d_m, Eigen::Vector3d::Constant(-1e3), Eigen::Vector3d::Constant(1e3));
}

Face plane(const Eigen::Vector3d& normal, double d_m, const Eigen::Vector3d& min_corner,
           const Eigen::Vector3d& max_corner) {
  return {normal.normalized(), d_m, Eigen::AlignedBox3d(min_corner, max_corner)};
}

World room() {
  return {plane(Eigen::Vector3d::UnitX(), 3.0), plane(-Eigen::Vector3d::UnitX(), 3.0),
          plane(Eigen::Vector3d::UnitY(), 2.5), plane(-Eigen::Vector3d::UnitY(), 2.5),
          plane(Eigen::Vector3d::UnitZ(), 0.0), plane(-Eigen::Vector3d::UnitZ(), 2.5)};
}

double range_m(const World& world, const Eigen::Vector3d& origin,
               const Eigen::Vector3d& direction) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Face& face : world) {
    const double approach = face.normal.dot(direction);
    if (approach == 0.0) continue;  // parallel to the face
    const double range = -(face.normal.dot(origin) + face.d_m) / approach;
    if (!(range > 0.0) || range >= nearest) continue;
    const Eigen::Vector3d hit = origin + range * direction;
    if (face.bounds.exteriorDistance(hit) < 1e-9) nearest = range;
  }
  return nearest;
}

Pose no_drift(double) { return Pose::Identity(); }

Pose wandering_drift(double time_s) {
  const double share = time_s / 15.0;
  return planar_pose(0.3 * share, -0.2 * std::sin(3.0 * share), 0.07 * share);
}

double to_and_fro(double time_s) {
  const double turn = 0.8 * time_s / (4.0 * 1.2);  // in periods
  return 1.2 * (4.0 * std::abs(turn - std::floor(turn + 0.5)) - 1.0);
}

Pose around_the_middle(double time_s) {
  const double angle = 2.0 * M_PI * time_s / 15.0;
  return planar_pose(0.6 * std::cos(angle) - 0.6, 0.6 * std::sin(angle), angle);
}

Motion tilting_in_place() {
  return {[](double) { return Pose::Identity(); }, to_and_fro, no_drift};
}

Pose T_base_laser(double tilt_rad) {
  return Eigen::Translation3d(0.0, 0.0, 1.2) *
         Eigen::AngleAxisd(tilt_rad, Eigen::Vector3d::UnitY());
}

Lines drive(const World& world, const Motion& motion, double from_s, double to_s,
            const Laser& laser) {
  std::mt19937 random(laser.seed);
  std::normal_distribution<double> noise_m(0.0, laser.range_sigma_m);
  Lines lines;
  for (int k = 0; from_s + k * kLinePeriod_s < to_s; ++k) {
    const double first_s = from_s + k * kLinePeriod_s, last_s = first_s + kScanTime_s;
    const double middle_s = 0.5 * (first_s + last_s);
    Line line;
    line.beams =
        measured_beams(world, motion, first_s, laser.beams, [&] { return noise_m(random); });
    line.T_map_base_true = motion.T_map_base(middle_s);
    line.poses = {motion.drift(first_s) * motion.T_map_base(first_s),
                  motion.drift(last_s) * motion.T_map_base(last_s),
                  T_base_laser(motion.tilt_rad(first_s)), T_base_laser(motion.tilt_rad(last_s)),
                  motion.drift(middle_s) * line.T_map_base_true};
    lines.push_back(line);
  }
  return lines;
}

std::vector<StampedPose> true_trajectory(const Lines& lines, std::size_t stride) {
  std::vector<StampedPose> trajectory;
  for (std::size_t i = 0; i < lines.size(); i += stride) {
    trajectory.push_back({middle_of(lines[i].beams), lines[i].T_map_base_true});
  }
  return trajectory;
}

Lines with_true_acquisition_poses(Lines lines) {
  for (Line& line : lines) line.poses.T_map_base = line.T_map_base_true;
  return lines;
}

Modeler model_of(const Lines& lines, const ModelerConfig& config) {
  Modeler modeler(config);
  for (const Line& line : lines) modeler.add_scan_line(line.beams, line.poses);
  return modeler;
}

}  // namespace ribbon_mapper::mini_world
