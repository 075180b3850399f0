// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "eval/experiment.hpp"

namespace ribbon_mapper::eval {

/// Shows progress on stderr: a bar that moves on a terminal, a line for every 10 % in a log.
class ProgressBar {
 public:
  ProgressBar();
  void show(const Progress& progress);

 private:
  bool on_terminal_;
  int step_percent_;
  int shown_percent_ = 0;
};

}  // namespace ribbon_mapper::eval
