// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>
#include <vector>

#include "modeler/ros/intake/line_intake.hpp"
#include "slam/node/estimate_worker.hpp"

namespace ribbon_mapper::slam {

/// Hands the scans of a level laser on the base over to the estimate, and lets lines of the tilting
/// laser wait for them. A laser that stops delays the lines once, and loses none.
class BaseLaserInput {
 public:
  /// Starts without scans. `topic` is the resolved one. A line waits for
  /// IntakeOptions::transform_timeout_s at most.
  BaseLaserInput(const IntakeOptions& options, std::string topic)
      : topic_(std::move(topic)), intake_(options, log_) {}
  BaseLaserInput(const BaseLaserInput&) = delete;  // its parts refer to each other
  BaseLaserInput& operator=(const BaseLaserInput&) = delete;

  /// Adds a scan that arrived at `now`.
  void add(const sensor_msgs::LaserScan& scan, const Moment& now) { intake_.add(scan, now); }

  /// Hands all scans over whose poses are known.
  void hand_over(const tf2::BufferCore& tf, const Moment& now, EstimateWorker& worker);

  /// Returns true if a line of this time need not wait any longer: the scans reach as far, or the
  /// laser is silent.
  bool lets_pass(Time line, const Moment& now);

  /// Counts scans that the estimate has refused, for these reasons.
  void refused(const std::vector<std::string>& reasons) {
    for (const std::string& reason : reasons) log_.dropped(reason);
  }

  /// Starts again, and drops the waiting scans for `reason`.
  void restart(const std::string& reason);
  /// Does the same when simulated time was set back, and goes on with the scans of the next run.
  void start_next_run(const std::string& reason);
  /// Counts from zero.
  void reset_counts() { log_ = {}; }

  /// Returns true if lines do not wait for this laser, as it has not come up to them.
  bool is_silent() const { return is_silent_; }

  /// Reports the scans, and that the laser is silent. `matched` of them refined the odometry.
  void diagnose(std::size_t matched, diagnostic_updater::DiagnosticStatusWrapper& report) const;

 private:
  void forget();

  std::string topic_;
  LineLog log_;
  LineIntake intake_;
  Time newest_{0}, newest_line_{0};
  std::optional<ros::WallTime> waits_since_;
  bool is_silent_ = false;
};

}  // namespace ribbon_mapper::slam
