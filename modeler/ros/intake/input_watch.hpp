// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>

#include <optional>
#include <string>

#include "modeler/ros/intake/line_intake.hpp"
#include "modeler/ros/intake/transform_buffer.hpp"

namespace ribbon_mapper {

/// Returns what is wrong with the clock, judged by the stamp of the newest scan; names the
/// parameter or option that is set wrongly. Returns nothing if clock and stamp agree within a
/// minute. A `clock` of zero means that there is no /clock yet.
std::optional<std::string> clock_fault(bool use_sim_time, const ros::Time& clock,
                                       const ros::Time& newest_stamp);

/// Finds out what the modeler is waiting for, so that its users need not guess.
class InputWatch {
 public:
  /// Creates a watch for the laser's resolved topic.
  explicit InputWatch(std::string scan_topic) : scan_topic_(std::move(scan_topic)) {}

  /// Takes note of a scan that came in.
  void saw(const sensor_msgs::LaserScan& scan);

  /// Returns what is missing, in words. Returns an empty text if lines have come in since the last
  /// call and are not held up. Asks the master who publishes scans if there are none.
  std::string complaint(const LineIntake& intake, const TransformBuffer& tf);

  /// Returns which transforms come later after their stamps than lines wait, and by how much; an
  /// empty text if none do.
  std::string lateness(const LineIntake& intake, const TransformBuffer& tf) const;

  /// Returns which frames there are, and how to set the parameters if there is one choice; an empty
  /// text if tf has all frames.
  std::string frames_advice(const LineIntake& intake, const TransformBuffer& tf) const;

 private:
  std::string without_scans() const;

  std::string scan_topic_;
  std::size_t scans_ = 0, scans_before_ = 0;
  Time done_before_{0};
  ros::Time newest_stamp_;
  std::string laser_frame_;
};

}  // namespace ribbon_mapper
