// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

#include "modeler/program/progress.hpp"

namespace ribbon_mapper {

/// Says on stderr what takes its time, if a person looks at it.
void tell_terminal(const std::string& what);

/// Shows progress on stderr: as a moving bar on a terminal, elsewhere as a line for every 10 %,
/// and between the first and the last at most one a second.
class ProgressBar {
 public:
  /// Starts the clock for the time left.
  ProgressBar();

  /// Erases an unfinished bar.
  ~ProgressBar();

  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Updates the bar, or prints a line if a further 10 % are done and a second has passed.
  void show(const Progress& progress);

  /// Prints lines to stdout, above the bar.
  void print(const std::string& lines);

 private:
  using Clock = std::chrono::steady_clock;

  bool is_due(int percent) const;
  std::string time_left(double done) const;
  void wipe() const;

  bool on_terminal_;
  int step_percent_;
  int shown_percent_ = -1;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
};

}  // namespace ribbon_mapper
