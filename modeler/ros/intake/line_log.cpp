// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/intake/line_log.hpp"

#include <algorithm>

namespace ribbon_mapper {
namespace {
constexpr std::size_t kMaxReasons = 100;
constexpr std::size_t kNewest = 1 << 15;  // lines: 14 minutes at 40 Hz
}  // namespace

void LineLog::dropped(const std::string& reason, const std::string& detail) {
  const bool is_known = dropped_.size() < kMaxReasons || dropped_.count(reason) != 0;
  ++dropped_[is_known ? reason : "other reasons"];
  newest_drop_ = detail.empty() ? reason : reason + " (" + detail + ")";
}

void LineLog::handled(const std::string& outcome, double seconds) {
  ++handled_[outcome];
  busy_s_ += seconds;
  if (newest_us_.size() < kNewest) newest_us_.push_back(0.0F);
  newest_us_[next_] = static_cast<float>(1e6 * seconds);
  next_ = (next_ + 1) % kNewest;
}

std::size_t LineLog::dropped_lines() const {
  std::size_t sum = 0;
  for (const auto& [reason, count] : dropped_) sum += count;
  return sum;
}

double LineLog::median_line_us() const {
  if (newest_us_.empty()) return 0.0;
  std::vector<float> times = newest_us_;
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

}  // namespace ribbon_mapper
