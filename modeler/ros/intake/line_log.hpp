// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "modeler/ros/intake/line_gaps.hpp"

namespace ribbon_mapper {

/// Statistics of the scan lines: how many came, what became of them, how long they took.
class LineLog {
 public:
  /// Counts a line that came in.
  void received() { ++received_; }
  /// Counts a line that never reached the model. `detail` tells people what was wrong with it.
  /// After a hundred different reasons, further ones are counted together.
  void dropped(const std::string& reason, const std::string& detail = "");
  /// Counts lines that never came in.
  void missing(const LineGap& gap) {
    lost_ += gap.lost;
    if (gap.silent_s > 0.0) ++gaps_, silent_s_ += gap.silent_s;
  }
  /// Counts a line whose time fields contradict the period of the lines, see timing_doubt().
  void doubted(const std::string& text) { ++doubted_, newest_doubt_ = text; }
  /// Counts a line that reached the model and the time that it took; see to_string(LineResult) for
  /// `outcome`.
  void handled(const std::string& outcome, double seconds);

  /// Returns the number of lines that came in.
  std::size_t lines() const { return received_; }
  /// Returns the number of lines that were sent, by header.seq, and never came in.
  std::size_t lost() const { return lost_; }
  /// Returns the number of gaps between lines in which none was sent, as far as header.seq tells.
  std::size_t gaps() const { return gaps_; }
  /// Returns the total time of these gaps.
  double silent_s() const { return silent_s_; }
  /// Returns the number of lines dropped.
  std::size_t dropped_lines() const;
  /// Returns reason and detail of the newest drop; empty if there was none.
  const std::string& newest_drop() const { return newest_drop_; }
  /// Returns the number of lines dropped for each reason.
  const std::map<std::string, std::size_t>& dropped_by_reason() const { return dropped_; }
  /// Returns the newest doubt about the time fields of lines; empty unless most lines had one.
  std::string timing_doubt() const { return 2 * doubted_ > received_ ? newest_doubt_ : ""; }
  /// Returns the number of lines with each outcome.
  const std::map<std::string, std::size_t>& handled_by_outcome() const { return handled_; }
  /// Returns the total computing time of all lines.
  double busy_s() const { return busy_s_; }
  /// Returns the median computing time of the newest lines; 0 before the first.
  double median_line_us() const;

 private:
  std::size_t received_ = 0;
  std::map<std::string, std::size_t> dropped_, handled_;
  std::string newest_drop_;
  std::size_t doubted_ = 0;
  std::string newest_doubt_;
  std::size_t lost_ = 0, gaps_ = 0;
  double silent_s_ = 0.0;
  double busy_s_ = 0.0;
  std::vector<float> newest_us_;  ///< ring
  std::size_t next_ = 0;
};

}  // namespace ribbon_mapper
