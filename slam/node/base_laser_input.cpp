// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/node/base_laser_input.hpp"

#include <algorithm>

namespace ribbon_mapper::slam {

using diagnostic_msgs::DiagnosticStatus;

void BaseLaserInput::hand_over(const tf2::BufferCore& tf, const Moment& now,
                               EstimateWorker& worker) {
  while (std::optional<ReadyLine> scan = intake_.take_next(tf, now)) {
    newest_ = middle_of(scan->beams);
    worker.add_base_scan(std::move(*scan));
  }
}

bool BaseLaserInput::lets_pass(Time line, const Moment& now) {
  newest_line_ = std::max(newest_line_, line);
  if (newest_ >= line) {
    is_silent_ = false;
    waits_since_.reset();
    return true;
  }
  if (is_silent_) return true;
  if (!waits_since_) waits_since_ = now.wall;
  is_silent_ = (now.wall - *waits_since_).toSec() > intake_.options().transform_timeout_s;
  if (is_silent_) waits_since_.reset();
  return is_silent_;
}

void BaseLaserInput::restart(const std::string& reason) {
  intake_.restart(reason);
  forget();
}

void BaseLaserInput::start_next_run(const std::string& reason) {
  intake_.start_next_run(reason);
  forget();
}

void BaseLaserInput::forget() {
  newest_ = newest_line_ = Time(0);
  waits_since_.reset();
  is_silent_ = false;
}

void BaseLaserInput::diagnose(std::size_t matched,
                              diagnostic_updater::DiagnosticStatusWrapper& report) const {
  const std::string fallback = "the recorded odometry is used";
  if (is_silent_) {
    report.summary(DiagnosticStatus::WARN, newest_ == Time(0)
                                               ? "no scan has come on " + topic_ + ": " + fallback
                                               : "silent: " + fallback);
  } else if (2 * log_.dropped_lines() > log_.lines()) {
    report.summary(DiagnosticStatus::WARN, "most scans cannot be used: " + log_.newest_drop());
  } else {
    report.summary(DiagnosticStatus::OK, matched > 0 ? "refines the odometry" : "no scans yet");
  }
  report.add("topic", topic_);
  report.add("scans in", log_.lines());
  report.add("scans dropped", log_.dropped_lines());
  report.add("scans matched", matched);
  report.add("newest drop", log_.newest_drop());
  report.add("waits for", intake_.waits_for());
  report.addf("behind the tilting laser [s]", "%.1f",
              std::max(0.0, to_seconds(newest_line_ - newest_)));
}

}  // namespace ribbon_mapper::slam
