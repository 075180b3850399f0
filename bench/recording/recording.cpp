// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/recording/recording.hpp"

#include <algorithm>

#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper::bench {

std::size_t Recording::beam_count() const {
  std::size_t count = 0;
  for (const RecordedLine& line : lines) count += line.beams.ranges_m.size();
  return count;
}

std::vector<std::size_t> returns_of(const Recording& recording, const ScanConfig& config) {
  std::vector<std::size_t> counts;
  ScanLine placed;
  for (const RecordedLine& line : recording.lines) {
    place_beams(line.beams, line.poses, config, placed);
    const auto& ranges_m = placed.ranges_m;
    counts.push_back(ranges_m.size() -
                     static_cast<std::size_t>(std::count(ranges_m.begin(), ranges_m.end(), 0.0F)));
  }
  return counts;
}

int repetitions_factor(const Recording& recording) {
  return 1 + static_cast<int>(5000 / recording.lines.size());
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
