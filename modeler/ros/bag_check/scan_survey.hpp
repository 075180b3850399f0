// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "modeler/ros/bag_check/bag_report.hpp"

namespace ribbon_mapper {

/// Statistics of the scans in a bag, without tf: stamps, gaps, kinds of ranges, noise.
class ScanSurvey {
 public:
  /// Adds a scan that was recorded at `recorded`.
  void add(const sensor_msgs::LaserScan& scan, const ros::Time& recorded);
  /// Adds the findings to a report.
  void report(BagReport& report) const;

  /// Returns the number of scans.
  std::size_t scans() const { return scans_; }
  /// Returns the angle between neighbouring beams.
  double beam_step_rad() const { return beam_step_rad_; }
  /// Returns the median time between scans; 0 for fewer than two scans.
  double median_period_s() const;
  /// Returns the median time from stamp to recording.
  double median_delay_s() const;
  /// Returns the median of the usable ranges; 0 if there are none.
  double median_range_m() const;
  /// Estimates the standard deviation of a range from second differences, which on a plane are
  /// noise alone. Takes the larger one of successive beams and of successive lines, because drivers
  /// may smooth along a line. Robust against edges. Returns 0 without enough ranges.
  double noise_m() const;

 private:
  void look_at_ranges(const sensor_msgs::LaserScan& scan);
  void look_at_noise(const sensor_msgs::LaserScan& scan);
  void report_stamps(BagReport& report) const;
  void report_ranges(BagReport& report) const;

  std::size_t scans_ = 0, without_stamp_ = 0, backwards_ = 0;
  std::map<std::string, std::size_t> defects_;
  std::set<std::string> frames_;
  std::size_t beams_ = 0;
  double first_angle_rad_ = 0.0, last_angle_rad_ = 0.0, beam_step_rad_ = 0.0;
  ros::Time newest_;
  std::vector<double> periods_s_, delays_s_;
  std::size_t ranges_ = 0, nan_ = 0, infinite_ = 0, zero_ = 0, out_of_range_ = 0;
  std::vector<float> some_ranges_m_;
  std::vector<float> last_ranges_m_, second_last_ranges_m_;
  std::vector<float> along_m_, across_m_;  ///< second differences
};

/// Returns the median of any values; 0 if there are none.
double median_of(std::vector<double> values);

}  // namespace ribbon_mapper
