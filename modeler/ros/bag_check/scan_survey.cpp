// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/scan_survey.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modeler/ros/bag_check/number_text.hpp"
#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

constexpr std::size_t kMaxSamples = 1'000'000;  // enough: the beginning of a long bag
constexpr double kEdge_m = 0.2;                 // larger second differences are jumps in depth
constexpr double kOtherClock_s = 60.0;

bool is_usable(float range_m, const sensor_msgs::LaserScan& scan) {
  return std::isfinite(range_m) && range_m > 0.0F && range_m >= scan.range_min &&
         range_m <= scan.range_max;
}

}  // namespace

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void ScanSurvey::add(const sensor_msgs::LaserScan& scan, const ros::Time& recorded) {
  ++scans_;
  frames_.insert(scan.header.frame_id);
  if (scan.header.stamp.isZero()) {
    ++without_stamp_;
  } else {
    const double period_s = scan.header.stamp.toSec() - newest_.toSec();
    if (!newest_.isZero() && period_s <= 0.0) ++backwards_;
    if (!newest_.isZero() && period_s > 0.0) periods_s_.push_back(period_s);
    newest_ = std::max(newest_, scan.header.stamp);
    delays_s_.push_back(recorded.toSec() - scan.header.stamp.toSec());
  }
  if (const auto defect = find_defect(scan)) {
    if (!scan.header.stamp.isZero()) ++defects_[*defect];
    return;
  }
  beams_ = scan.ranges.size();
  first_angle_rad_ = scan.angle_min, last_angle_rad_ = scan.angle_max;
  beam_step_rad_ = std::abs(scan.angle_increment);
  look_at_ranges(scan);
}

void ScanSurvey::look_at_ranges(const sensor_msgs::LaserScan& scan) {
  ranges_ += scan.ranges.size();
  for (const float range_m : scan.ranges) {
    if (std::isnan(range_m))
      ++nan_;
    else if (std::isinf(range_m))
      ++infinite_;
    else if (range_m == 0.0F)
      ++zero_;
    else if (!is_usable(range_m, scan))
      ++out_of_range_;
    else if (some_ranges_m_.size() < kMaxSamples)
      some_ranges_m_.push_back(range_m);
  }
  look_at_noise(scan);
}

void ScanSurvey::look_at_noise(const sensor_msgs::LaserScan& scan) {
  const std::vector<float>&r = scan.ranges, &last = last_ranges_m_, &before = second_last_ranges_m_;
  const auto take = [&](float a, float b, float c, std::vector<float>& differences) {
    if (!is_usable(a, scan) || !is_usable(b, scan) || !is_usable(c, scan)) return;
    const float difference = std::abs(a - 2.0F * b + c);
    if (difference < kEdge_m && differences.size() < kMaxSamples) differences.push_back(difference);
  };
  for (std::size_t i = 2; i < r.size(); ++i) take(r[i], r[i - 1], r[i - 2], along_m_);
  if (last.size() == r.size() && before.size() == r.size()) {
    for (std::size_t i = 0; i < r.size(); ++i) take(r[i], last[i], before[i], across_m_);
  }
  second_last_ranges_m_ = std::exchange(last_ranges_m_, r);
}

double ScanSurvey::median_period_s() const { return median_of(periods_s_); }

double ScanSurvey::median_delay_s() const { return median_of(delays_s_); }

double ScanSurvey::median_range_m() const {
  return median_of({some_ranges_m_.begin(), some_ranges_m_.end()});
}

double ScanSurvey::noise_m() const {
  const double along_m = median_of({along_m_.begin(), along_m_.end()});
  const double across_m = median_of({across_m_.begin(), across_m_.end()});
  // The median of |x| is 0.6745 sigma; a second difference has the variance (1 + 4 + 1) sigma^2.
  return std::max(along_m, across_m) / 0.6745 / std::sqrt(6.0);
}

void ScanSurvey::report(BagReport& report) const {
  report_stamps(report);
  for (const auto& [defect, count] : defects_) {
    const std::string text =
        counted(count, "scan") + " of " + std::to_string(scans_) + " cannot be used: " + defect;
    2 * count > scans_ ? report.fault(text) : report.warning(text);
  }
  if (frames_.size() > 1) {
    report.warning("scans come in " + std::to_string(frames_.size()) +
                   " different frames: are two lasers on one topic?");
  }
  for (const std::string& frame : frames_) {
    if (frame != without_slash(frame)) {
      report.fact("the scans' frame " + frame + " has a leading slash; it is stripped");
    }
  }
  if (beams_ > 0) report_ranges(report);
}

void ScanSurvey::report_stamps(BagReport& report) const {
  if (2 * without_stamp_ > scans_) {
    report.fault("scans have no stamp (zero): their poses cannot be looked up");
    return;
  }
  if (without_stamp_ > 0) report.warning(counted(without_stamp_, "scan") + " without a stamp");
  const double period_s = median_period_s();
  if (period_s > 0.0) {
    report.fact(counted(scans_, "scan") + " of " + counted(beams_, "beam") + " at " +
                number(1.0 / period_s, 1) + " Hz, from " + degrees(first_angle_rad_) + " to " +
                degrees(last_angle_rad_) + " degrees");
  }
  if (backwards_ > 0) {
    const std::string text = "stamps of scans go backwards or stand still " +
                             std::to_string(backwards_) +
                             " times: were two recordings put together, or did time jump?";
    4 * backwards_ > scans_ ? report.fault(text) : report.warning(text);
  }
  const double longest_s =
      periods_s_.empty() ? 0.0 : *std::max_element(periods_s_.begin(), periods_s_.end());
  if (longest_s > std::max(1.0, 10.0 * period_s)) {
    report.warning("no scans for " + number(longest_s, 1) + " s: lines are missing");
  }
  const double delay_s = median_of(delays_s_);
  if (std::abs(delay_s) > kOtherClock_s) {
    report.warning("scans are stamped " + number(delay_s, 0) +
                   " s before they were recorded: two clocks; all stamps must be of one");
  }
}

void ScanSurvey::report_ranges(BagReport& report) const {
  const auto share = [this](std::size_t count) {
    return number(100.0 * static_cast<double>(count) / static_cast<double>(ranges_), 1) + " %";
  };
  const std::size_t usable = ranges_ - nan_ - infinite_ - zero_ - out_of_range_;
  report.fact("ranges: " + share(usable) + " usable (median " + number(median_range_m(), 2) +
              " m), " + share(infinite_) + " infinite, " + share(nan_) + " NaN, " + share(zero_) +
              " zero, " + share(out_of_range_) + " out of the sensor's range");
  if (usable == 0) {
    report.fault("not one range is usable: is the laser covered, or its driver broken?");
  } else if (10 * usable < ranges_) {
    report.warning("only " + share(usable) + " of the ranges are usable");
  }
  if (zero_ > 0) report.fact("ranges of zero (a driver older than REP 117) count as no return");
}

}  // namespace ribbon_mapper
