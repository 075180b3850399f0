// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

#include "modeler/program/progress.hpp"

namespace ribbon_mapper {

/// Says on stderr what takes its time, if a person looks at it.
void tell_terminal(const std::string& what);

/// Shows progress on stderr: as a moving bar on a terminal, as a line for every 10 % elsewhere.
class ProgressBar {
 public:
  /// Starts the clock for the time left.
  ProgressBar();

  /// Erases an unfinished bar.
  ~ProgressBar();

  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Updates the bar, or prints a line if a further 10 % are done.
  void show(const Progress& progress);

  /// Prints lines to stdout, above the bar.
  void print(const std::string& lines);

 private:
  std::string time_left(double done) const;
  void wipe() const;

  bool on_terminal_;
  int step_percent_;
  int shown_percent_ = -1;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace ribbon_mapper
