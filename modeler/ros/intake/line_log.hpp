// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace ribbon_mapper {

/// What became of the lines, and how long they took.
class LineLog {
 public:
  void received() { ++received_; }
  /// `detail` is for people: what exactly was wrong with this one.
  void dropped(const std::string& reason, const std::string& detail = "") {
    ++dropped_[reason];
    newest_drop_ = detail.empty() ? reason : reason + " (" + detail + ")";
  }
  /// A line that reached the model; `outcome` as the modeler names it.
  void handled(const std::string& outcome, double seconds);

  std::size_t lines() const { return received_; }
  std::size_t dropped_lines() const;
  const std::string& newest_drop() const { return newest_drop_; }
  const std::map<std::string, std::size_t>& dropped_by_reason() const { return dropped_; }
  const std::map<std::string, std::size_t>& handled_by_outcome() const { return handled_; }
  double busy_s() const { return busy_s_; }  ///< computing, all in all
  double median_line_us() const;             ///< of the newest lines

 private:
  std::size_t received_ = 0;
  std::map<std::string, std::size_t> dropped_, handled_;
  std::string newest_drop_;
  double busy_s_ = 0.0;
  std::vector<float> newest_us_;  ///< ring
  std::size_t next_ = 0;
};

}  // namespace ribbon_mapper
