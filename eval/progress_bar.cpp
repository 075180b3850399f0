// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/progress_bar.hpp"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace ribbon_mapper::eval {
namespace {

constexpr int kBarWidth = 40;

int percent_of(const Progress& progress) {
  return progress.lines == 0 ? 100 : static_cast<int>(100 * progress.line / progress.lines);
}

}  // namespace

ProgressBar::ProgressBar()
    : on_terminal_(isatty(STDERR_FILENO) == 1), step_percent_(on_terminal_ ? 1 : 10) {}

void ProgressBar::show(const Progress& progress) {
  const int percent = percent_of(progress);
  if (percent < shown_percent_ + step_percent_) return;
  shown_percent_ = percent - percent % step_percent_;
  const auto filled = static_cast<std::size_t>(kBarWidth * percent / 100);
  const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
  std::fprintf(stderr, "%s[%s] %3d %%  %zu of %zu lines, %zu ribbons, %.1f x real time%s",
               on_terminal_ ? "\r" : "", bar.c_str(), percent, progress.line, progress.lines,
               progress.ribbons, progress.real_time_factor,
               on_terminal_ && percent < 100 ? "" : "\n");
}

}  // namespace ribbon_mapper::eval
