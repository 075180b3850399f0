// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/program/progress_bar.hpp"

#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace ribbon_mapper {
namespace {

constexpr int kBarWidth = 16;  // the whole line fits into 80 columns
constexpr std::chrono::seconds kBetweenLines{1};
constexpr const char* kWipeLine = "\r\x1b[K";  // erases to the end of the line

double share_done(const Progress& progress) {
  if (progress.lines == 0) return 0.0;
  return static_cast<double>(progress.line) / static_cast<double>(progress.lines);
}

std::string bar(int percent) {
  const auto filled = static_cast<std::size_t>(kBarWidth * percent / 100);
  return "[" + std::string(filled, '#') + std::string(kBarWidth - filled, '.') + "] ";
}

std::string figures(const Progress& progress) {
  if (progress.modeler_s == 0.0)
    return std::to_string(progress.line) + (progress.line == 1 ? " line" : " lines");
  std::array<char, 96> text;
  std::snprintf(text.data(), text.size(), "%zu lines, %zu ribbons, %.0f x real time", progress.line,
                progress.ribbons, real_time_factor(progress));
  return text.data();
}

bool is_on_terminal() { return isatty(STDERR_FILENO) == 1; }

}  // namespace

void tell_terminal(const std::string& what) {
  if (is_on_terminal()) std::fprintf(stderr, "%s ...\n", what.c_str());
}

ProgressBar::ProgressBar() : on_terminal_(is_on_terminal()), step_percent_(on_terminal_ ? 1 : 10) {}

ProgressBar::~ProgressBar() { wipe(); }

void ProgressBar::show(const Progress& progress) {
  const auto percent = static_cast<int>(100.0 * share_done(progress));
  if (!is_due(percent)) return;
  shown_ = Clock::now();
  shown_percent_ = percent - percent % step_percent_;
  std::fprintf(stderr, "%s%s%3d %%  %s%s%s", on_terminal_ ? kWipeLine : "",
               on_terminal_ ? bar(percent).c_str() : "", percent, figures(progress).c_str(),
               time_left(share_done(progress)).c_str(), on_terminal_ ? "" : "\n");
}

bool ProgressBar::is_due(int percent) const {
  if (shown_percent_ < 0) return true;
  if (!on_terminal_ && percent < 100 && Clock::now() < shown_ + kBetweenLines) return false;
  return percent >= shown_percent_ + step_percent_;
}

void ProgressBar::print(const std::string& lines) {
  wipe();
  std::fputs(lines.c_str(), stdout);
  std::fflush(stdout);
  shown_percent_ = on_terminal_ ? -1 : shown_percent_;  // the bar reappears at the next step
}

// Extrapolates from the share done, once that is meaningful.
std::string ProgressBar::time_left(double done) const {
  if (done < 0.02 || done >= 1.0) return "";
  const std::chrono::duration<double> passed = Clock::now() - start_;
  const auto left_s = static_cast<int>(std::lround(passed.count() * (1.0 - done) / done));
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), ", %d:%02d left", left_s / 60, left_s % 60);
  return text.data();
}

void ProgressBar::wipe() const {
  if (on_terminal_) std::fputs(kWipeLine, stderr);
}

}  // namespace ribbon_mapper
