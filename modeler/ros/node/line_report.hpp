// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstddef>
#include <string>

#include "modeler/ros/intake/input_watch.hpp"
#include "modeler/ros/intake/line_intake.hpp"
#include "modeler/ros/intake/transform_buffer.hpp"

namespace ribbon_mapper {

/// Tells the users of a node what becomes of its lines: on /diagnostics and in the log.
class LineReport {
 public:
  /// Starts a report on the laser's resolved topic. `log`, `intake` and `tf` must outlive this.
  LineReport(const LineLog& log, const LineIntake& intake, const TransformBuffer& tf,
             const std::string& scan_topic)
      : log_(log), intake_(intake), tf_(tf), scan_topic_(scan_topic), watch_(scan_topic) {}

  /// Takes note of a scan that came in.
  void saw(const sensor_msgs::LaserScan& scan) { watch_.saw(scan); }

  /// Reports the lines received, and the lines dropped by reason.
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  /// Logs that lines were dropped or lost since the last call.
  void warn();

  /// Returns what the node is waiting for, see InputWatch::complaint().
  std::string complaint() { return watch_.complaint(intake_, tf_); }

  /// Starts again, with a log that was emptied.
  void restart() { diagnosed_ = warned_ = {}; }

 private:
  /// The counts at the last report.
  struct Counts {
    std::size_t lines = 0, dropped = 0, lost = 0, gaps = 0;
  };
  Counts counts() const { return {log_.lines(), log_.dropped_lines(), log_.lost(), log_.gaps()}; }

  const LineLog& log_;
  const LineIntake& intake_;
  const TransformBuffer& tf_;
  std::string scan_topic_;
  InputWatch watch_;
  Counts diagnosed_, warned_;
};

}  // namespace ribbon_mapper
