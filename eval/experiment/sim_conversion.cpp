// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment/sim_conversion.hpp"

#include "sim/robot/pr2.hpp"

namespace ribbon_mapper::eval {

LaserBeams beams_of(const sim::Scan& scan) {
  return {scan.stamp,
          scan.angle_min_rad,
          scan.angle_increment_rad,
          scan.time_increment_s,
          scan.range_min_m,
          scan.range_max_m,
          scan.ranges_m};
}

LinePoses noisy_poses(const sim::Tour& tour, const LaserBeams& beams) {
  const Time first = beams.stamp, last = end_of(beams);
  return {tour.T_odom_base(first), tour.T_odom_base(last), tour.T_base_laser(first),
          tour.T_base_laser(last), tour.noisy_T_map_base(middle_of(beams))};
}

LinePoses base_laser_poses(const sim::Tour& tour, const LaserBeams& beams) {
  const Time first = beams.stamp, last = end_of(beams);
  const Pose T_base_laser = sim::pr2::T_base_base_laser();
  return {tour.T_odom_base(first), tour.T_odom_base(last), T_base_laser, T_base_laser,
          tour.noisy_T_map_base(middle_of(beams))};
}

std::vector<StampedPose> true_poses(const sim::Tour& tour, std::vector<StampedPose> trajectory) {
  for (StampedPose& pose : trajectory) pose.T_map_base = tour.true_T_map_base(pose.stamp);
  return trajectory;
}

std::vector<Patch> patches_of(const std::vector<sim::TruthPlane>& planes) {
  std::vector<Patch> patches;
  patches.reserve(planes.size());
  for (const sim::TruthPlane& plane : planes) {
    patches.push_back({plane.normal, plane.d_m, plane.area_m2, plane.axis_u, plane.cells});
  }
  return patches;
}

}  // namespace ribbon_mapper::eval
