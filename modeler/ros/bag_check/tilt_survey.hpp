// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/ros/bag_check/bag_report.hpp"
#include "modeler/ros/bag_check/line_spacing.hpp"
#include "modeler/ros/bag_check/scan_survey.hpp"
#include "modeler/scan/laser_beams.hpp"

namespace ribbon_mapper {

/// Statistics of the laser's motion: whether it tilts or turns, its period, the spacing of its
/// lines.
class TiltSurvey {
 public:
  /// Adds a scan line with its poses.
  void add(const LaserBeams& beams, const LinePoses& poses);
  /// Adds the findings to a report; `scans` has the same bag. The spacing of lines and beams is
  /// judged by a preset.
  void report(const ScanSurvey& scans, const ModelerConfig& preset, BagReport& report) const;

  /// Returns the spacing of lines and beams; `scans` has the same bag.
  LineSpacing spacing(const ScanSurvey& scans) const;

 private:
  std::vector<double> angles_rad() const;  ///< of each line about the main axis of rotation
  void report_tilt(BagReport& report) const;

  std::vector<Time> stamps_;
  std::vector<Eigen::Vector3d> turns_rad_;  ///< rotation vectors from line to line, in base
  Eigen::Matrix3d sum_of_squares_ = Eigen::Matrix3d::Zero();  ///< of the turns
  Pose last_T_base_laser_ = Pose::Identity();
  Pose first_T_odom_base_ = Pose::Identity();
  double base_travel_m_ = 0.0, base_turn_rad_ = 0.0;  ///< maximum distance from the first pose
};

}  // namespace ribbon_mapper
