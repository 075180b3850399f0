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
#include "modeler/scan/no_return_filter.hpp"

namespace ribbon_mapper {

/// Statistics of the scans in a bag, without tf: stamps, gaps, kinds of ranges, noise.
class ScanSurvey {
 public:
  /// Creates a survey without scans. `config` limits the ranges that count as returns.
  explicit ScanSurvey(const ScanConfig& config = {}) : no_returns_(config) {}

  /// Adds a scan that was recorded at `recorded`.
  void add(const sensor_msgs::LaserScan& scan, const ros::Time& recorded);
  /// Adds beams without a message: only their angles and ranges.
  void add(const LaserBeams& beams);
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
  /// Returns the usable range below which this share of them lies, 0.5 for the median; 0 if there
  /// are none.
  double range_m(double share) const;
  /// Estimates the standard deviation of a range from second differences, which on a plane are
  /// noise alone. Takes the larger one of successive beams and of successive lines, because drivers
  /// may smooth along a line. Robust against edges. Returns 0 without enough ranges.
  double noise_m() const;

 private:
  void count_ranges(const LaserBeams& beams);
  void look_at_noise(const LaserBeams& beams);
  void report_stamps(BagReport& report) const;
  void report_angles(BagReport& report) const;
  void report_time_increment(BagReport& report) const;
  void report_ranges(BagReport& report) const;

  std::size_t scans_ = 0, without_stamp_ = 0, backwards_ = 0;
  std::map<std::string, std::size_t> defects_;
  std::set<std::string> frames_;
  std::size_t min_beams_ = 0, max_beams_ = 0;
  double missing_beams_ = 0.0;  ///< at most, see missing_beams()
  LaserBeams last_;
  double scan_time_s_ = 0.0;
  double first_angle_rad_ = 0.0, last_angle_rad_ = 0.0, beam_step_rad_ = 0.0;
  ros::Time last_stamp_;
  std::vector<double> periods_s_, delays_s_;
  NoReturnFilter no_returns_;
  std::size_t ranges_ = 0, nan_ = 0, infinite_ = 0, zero_ = 0, out_of_range_ = 0;
  std::vector<float> some_ranges_m_;
  std::vector<float> last_ranges_m_, second_last_ranges_m_;
  std::vector<float> along_m_, across_m_;  ///< second differences
};

/// Returns the median of any values; 0 if there are none.
double median_of(std::vector<double> values);

}  // namespace ribbon_mapper
