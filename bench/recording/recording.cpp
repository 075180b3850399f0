// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/recording/recording.hpp"

#include <algorithm>
#include <cmath>

namespace ribbon_mapper::bench {

std::size_t Recording::beam_count() const {
  std::size_t count = 0;
  for (const RecordedLine& line : lines) count += line.beams.ranges_m.size();
  return count;
}

std::size_t Recording::return_count() const {
  std::size_t count = 0;
  for (const RecordedLine& line : lines) {
    count += static_cast<std::size_t>(
        std::count_if(line.beams.ranges_m.begin(), line.beams.ranges_m.end(),
                      [](float range_m) { return std::isfinite(range_m); }));
  }
  return count;
}

std::vector<StampedPose> true_trajectory(const Recording& recording) {
  std::vector<StampedPose> trajectory;
  for (const RecordedLine& line : recording.lines) {
    trajectory.push_back({middle_of(line.beams), line.T_map_base_true});
  }
  return trajectory;
}

LinePoses with_true_pose(const RecordedLine& line) {
  LinePoses poses = line.poses;
  poses.T_map_base = line.T_map_base_true;
  return poses;
}

Recording head_of(const Recording& recording, std::size_t lines) {
  Recording head = recording;
  head.duration_s *= static_cast<double>(lines) / static_cast<double>(recording.lines.size());
  head.lines.resize(lines);
  return head;
}

}  // namespace ribbon_mapper::bench
