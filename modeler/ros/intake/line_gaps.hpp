// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace ribbon_mapper {

/// What is missing between two lines.
struct LineGap {
  std::size_t lost = 0;  ///< lines that the laser's driver has sent, by header.seq
  double silent_s = 0;   ///< time without lines, if header.seq does not tell that any were sent
};

/// Finds lines that are missing among those that arrive. If header.seq counts the lines in step
/// with their stamps, it tells how many were sent: these were lost by a queue that was full, or on
/// the way. Else a gap is a step of more than one and a half periods between stamps. The period is
/// the median of the last steps.
class LineGaps {
 public:
  /// Takes the next line and returns what is missing before it. Lines out of order are left out.
  LineGap saw(std::uint32_t seq, const ros::Time& stamp) {
    const double step_s = newest_.isZero() ? 0.0 : stamp.toSec() - newest_.toSec();
    if (!newest_.isZero() && step_s <= 0.0) {
      saw_unusable();
      return {};
    }
    const LineGap gap = newest_.isZero() ? LineGap{} : gap_of(seq - seq_, step_s);
    newest_ = stamp, seq_ = seq, unusable_ = 0;
    return gap;
  }

  /// Takes note of a line that has come, but has no usable stamp.
  void saw_unusable() { ++unusable_; }

  /// Returns the median time between the last lines that were sent; 0 until there are some.
  double period_s() const {
    if (steps_ < kMinSteps) return 0.0;
    std::array<double, 15> steps_s = last_steps_s_;
    const auto end =
        steps_s.begin() + static_cast<std::ptrdiff_t>(std::min(steps_, steps_s.size()));
    const auto middle = steps_s.begin() + (end - steps_s.begin()) / 2;
    std::nth_element(steps_s.begin(), middle, end);
    return *middle;
  }

  /// Starts again: the next line does not follow the last one.
  void restart() { *this = {}; }

 private:
  static constexpr std::size_t kMinSteps = 5;
  static constexpr double kMaxPeriods = 1.5;  // half way between none and one missing
  static constexpr std::uint32_t kMaxSent = 10'000'000;
  static constexpr std::uint32_t kFewSent = 10;

  /// Returns what is missing in a step between two lines, `sent` by header.seq.
  LineGap gap_of(std::uint32_t sent, double step_s) {
    LineGap gap;
    if (steps_ >= kMinSteps) {
      const double periods = step_s / period_s();
      const double periods_each = periods / std::max(1U, sent);
      if (sent > 1 && sent < kMaxSent && periods_each > 0.5 && periods_each < kMaxPeriods) {
        gap.lost = sent - 1 - std::min(sent - 1, unusable_);
      } else if (periods > kMaxPeriods) {
        gap.silent_s = step_s;
      }
    }
    const bool is_few = sent >= 1 && sent <= kFewSent;
    last_steps_s_[steps_++ % last_steps_s_.size()] = is_few ? step_s / sent : step_s;
    return gap;
  }

  ros::Time newest_;
  std::uint32_t seq_ = 0, unusable_ = 0;  ///< unusable: lines since the newest
  std::array<double, 15> last_steps_s_{};
  std::size_t steps_ = 0;
};

}  // namespace ribbon_mapper
