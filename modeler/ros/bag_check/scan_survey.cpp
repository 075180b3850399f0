// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/scan_survey.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "modeler/ros/bag_check/number_text.hpp"
#include "modeler/ros/intake/model_doubts.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/messages/time_increment.hpp"

namespace ribbon_mapper {
namespace {

constexpr std::size_t kMaxSamples = 1'000'000;  // enough: the beginning of a long bag
constexpr double kEdge_m = 0.2;                 // larger second differences are jumps in depth
constexpr double kOtherClock_s = 60.0;

bool is_usable(float range_m, const LaserBeams& beams) {
  return std::isfinite(range_m) && range_m > 0.0F && range_m >= beams.range_min_m &&
         range_m <= beams.range_max_m;
}

/// Returns a share as a percentage.
std::string percent(double share) { return number(100.0 * share, 1) + " %"; }

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
    const double period_s = scan.header.stamp.toSec() - last_stamp_.toSec();
    if (!last_stamp_.isZero() && period_s <= 0.0) ++backwards_;
    if (!last_stamp_.isZero() && period_s > 0.0) periods_s_.push_back(period_s);
    last_stamp_ = scan.header.stamp;
    delays_s_.push_back(recorded.toSec() - scan.header.stamp.toSec());
  }
  if (const auto defect = find_defect(scan)) {
    if (!scan.header.stamp.isZero()) ++defects_[*defect];
    return;
  }
  const std::size_t beams = scan.ranges.size();
  min_beams_ = max_beams_ == 0 ? beams : std::min(min_beams_, beams);
  max_beams_ = std::max(max_beams_, beams);
  missing_beams_ = std::max(missing_beams_, missing_beams(scan));
  scan_time_s_ = scan.scan_time;
  first_angle_rad_ = scan.angle_min, last_angle_rad_ = scan.angle_max;
  add(beams_of(scan));
}

void ScanSurvey::add(const LaserBeams& beams) {
  last_ = beams;
  beam_step_rad_ = std::abs(beams.angle_increment_rad);
  count_ranges(no_returns_.filter(beams));
}

void ScanSurvey::count_ranges(const LaserBeams& beams) {
  ranges_ += beams.ranges_m.size();
  for (const float range_m : beams.ranges_m) {
    if (std::isnan(range_m))
      ++nan_;
    else if (std::isinf(range_m))
      ++infinite_;
    else if (range_m == 0.0F)
      ++zero_;
    else if (!is_usable(range_m, beams))
      ++out_of_range_;
    else if (some_ranges_m_.size() < kMaxSamples)
      some_ranges_m_.push_back(range_m);
  }
  look_at_noise(beams);
}

void ScanSurvey::look_at_noise(const LaserBeams& beams) {
  const std::vector<float>&r = beams.ranges_m, &last = last_ranges_m_,
        &before = second_last_ranges_m_;
  const auto take = [&](float a, float b, float c, std::vector<float>& differences) {
    if (!is_usable(a, beams) || !is_usable(b, beams) || !is_usable(c, beams)) return;
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

double ScanSurvey::range_m(double share) const {
  if (some_ranges_m_.empty()) return 0.0;
  std::vector<float> ranges_m = some_ranges_m_;
  const auto at = ranges_m.begin() +
                  static_cast<std::ptrdiff_t>(share * static_cast<double>(ranges_m.size() - 1));
  std::nth_element(ranges_m.begin(), at, ranges_m.end());
  return *at;
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
  if (max_beams_ == 0) return;
  report_angles(report);
  report_time_increment(report);
  report_ranges(report);
}

void ScanSurvey::report_stamps(BagReport& report) const {
  if (2 * without_stamp_ > scans_) {
    report.fault("scans have no stamp (zero): their poses cannot be looked up");
    return;
  }
  if (without_stamp_ > 0) report.warning(counted(without_stamp_, "scan") + " without a stamp");
  const double period_s = median_period_s();
  if (period_s > 0.0) {
    const std::string least =
        min_beams_ < max_beams_ ? std::to_string(min_beams_) + " to " : std::string();
    report.fact(counted(scans_, "scan") + " of " + least + counted(max_beams_, "beam") + " at " +
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

void ScanSurvey::report_angles(BagReport& report) const {
  if (missing_beams_ <= 1.5) return;
  report.warning("angle_max counts " + number(missing_beams_, 0) +
                 " beams more than there are ranges: beams are placed by angle_min and "
                 "angle_increment alone. Correct the driver, or the filter that crops ranges");
}

void ScanSurvey::report_time_increment(BagReport& report) const {
  if (last_.time_increment_s == 0.0) {
    report.fact("time_increment is 0: all beams of a line count as taken at its stamp");
    return;
  }
  const auto doubt = timing_doubt(last_, scan_time_s_, median_period_s());
  if (doubt) doubt->is_fault ? report.warning(doubt->text) : report.fact(doubt->text);
}

void ScanSurvey::report_ranges(BagReport& report) const {
  const auto share = [this](std::size_t count) {
    return percent(static_cast<double>(count) / static_cast<double>(ranges_));
  };
  const std::size_t usable = ranges_ - nan_ - infinite_ - zero_ - out_of_range_;
  report.fact("ranges: " + share(usable) + " usable (median " + number(range_m(0.5), 2) + " m), " +
              share(infinite_) + " infinite, " + share(nan_) + " NaN, " + share(zero_) + " zero, " +
              share(out_of_range_) + " out of the sensor's range");
  if (usable == 0) {
    report.fault("not one range is usable: is the laser covered, or its driver broken?");
  } else if (10 * usable < ranges_) {
    report.warning("only " + share(usable) + " of the ranges are usable");
  }
  if (const auto no_return = no_returns_.found()) {
    report.warning(no_return_text(*no_return) + ". Correct the driver: REP 117 wants infinity");
  }
  if (last_.range_max_m == std::numeric_limits<double>::infinity()) {
    report.fact("range_max is not set: only scan.max_range_m limits ranges");
  }
  if (zero_ > 0) report.fact("ranges of zero (a driver older than REP 117) count as no return");
}

}  // namespace ribbon_mapper
