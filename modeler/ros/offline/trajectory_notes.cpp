// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/offline/trajectory_notes.hpp"

#include <algorithm>

#include "modeler/ros/bag_check/number_text.hpp"

namespace ribbon_mapper {

bool stands_still(const std::vector<StampedPose>& trajectory) {
  const Pose T_first_map = trajectory.front().T_map_base.inverse(Eigen::Isometry);
  return std::all_of(trajectory.begin(), trajectory.end(), [&](const StampedPose& pose) {
    const Pose moved = T_first_map * pose.T_map_base;
    return moved.translation().norm() < 0.001 && angle_of(moved) < 0.001;
  });
}

double largest_move_m(const std::vector<StampedPose>& before,
                      const std::vector<StampedPose>& after) {
  double largest_m = 0.0;
  for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
    const Eigen::Vector3d way =
        after[i].T_map_base.translation() - before[i].T_map_base.translation();
    largest_m = std::max(largest_m, way.norm());
  }
  return largest_m;
}

std::optional<std::string> lacking_time(const std::vector<StampedPose>& lines,
                                        const std::vector<StampedPose>& corrected) {
  if (corrected.empty()) return std::nullopt;
  const Time begin = std::max(lines.front().stamp, corrected.front().stamp);
  const Time end = std::min(lines.back().stamp, corrected.back().stamp);
  const double all_s = to_seconds(lines.back().stamp - lines.front().stamp);
  const double covered_s = std::max(0.0, to_seconds(end - begin));
  if (covered_s >= 0.95 * all_s) return std::nullopt;
  return "the trajectory covers " + number(covered_s, 1) + " s of the " + number(all_s, 1) +
         " s of the lines: before and after it, the nearest change applies, and drift remains";
}

}  // namespace ribbon_mapper
