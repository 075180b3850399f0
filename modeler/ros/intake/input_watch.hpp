// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>

#include <optional>
#include <string>

#include "modeler/ros/intake/line_intake.hpp"

namespace ribbon_mapper {

/// What is wrong with the clock, told from the newest scan's stamp: names the parameter or the
/// option that is set wrongly. Nothing if they agree within a minute. A clock of zero: there is no
/// /clock yet.
std::optional<std::string> clock_fault(bool use_sim_time, const ros::Time& clock,
                                       const ros::Time& newest_stamp);

/// Says what the modeler is waiting for, so that nobody has to guess why there are no planes.
class InputWatch {
 public:
  explicit InputWatch(std::string scan_topic) : scan_topic_(std::move(scan_topic)) {}

  void saw(const sensor_msgs::LaserScan& scan);

  /// What is missing, in words; empty if lines have come in since the last call and are not held
  /// up. Asks the master who publishes scans when there are none.
  std::string complaint(const LineIntake& intake, std::size_t transforms);

 private:
  std::string without_scans() const;

  std::string scan_topic_;
  std::size_t scans_ = 0, scans_before_ = 0;
  Time done_before_{0};
  ros::Time newest_stamp_;
};

}  // namespace ribbon_mapper
