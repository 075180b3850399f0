// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/recording/bag_recording.hpp"

#include <ros/time.h>

#include <stdexcept>

#include "modeler/ros/intake/line_log.hpp"

namespace ribbon_mapper::bench {
namespace {

constexpr std::size_t kMinLines = 100;  // a few seconds; less gives no reliable times

RecordedLine recorded(const ReadyLine& ready) {
  RecordedLine line;
  line.beams = ready.beams;
  line.poses = ready.poses;
  line.T_map_base_true = ready.poses.T_map_base;
  const Pose T_odom_base =
      interpolate(ready.poses.T_odom_base_first, ready.poses.T_odom_base_last, 0.5);
  line.T_map_odom_true = line.T_map_base_true * T_odom_base.inverse(Eigen::Isometry);
  return line;
}

/// Returns the duration, assuming that the last line lasts as long as the others.
double duration_s_of(const std::vector<RecordedLine>& lines) {
  const auto periods = static_cast<double>(lines.size() - 1);
  const Time first_to_last = lines.back().beams.stamp - lines.front().beams.stamp;
  return to_seconds(first_to_last) * (periods + 1.0) / periods;
}

}  // namespace

Recording recording_of_bag(const std::filesystem::path& file, const BagOptions& options) {
  ros::Time::init();
  LineLog log;
  Recording recording;
  recording.name = file.stem().string();
  BagLines lines({file}, options, log);
  while (const auto line = lines.next()) recording.lines.push_back(recorded(*line));
  if (recording.lines.size() < kMinLines) {
    const std::string drop = log.newest_drop().empty() ? "" : " (" + log.newest_drop() + ")";
    throw std::runtime_error(file.string() + ": " + std::to_string(recording.lines.size()) +
                             " lines of " + std::to_string(log.lines()) + " have poses" + drop +
                             ", too few to measure; run bag_check for details");
  }
  recording.duration_s = duration_s_of(recording.lines);
  return recording;
}

}  // namespace ribbon_mapper::bench
