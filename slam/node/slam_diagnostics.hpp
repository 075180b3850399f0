// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include "modeler/ros/node/line_report.hpp"
#include "slam/node/base_laser_input.hpp"
#include "slam/node/estimate_worker.hpp"

namespace ribbon_mapper::slam {

/// Reports the state of the node `slam` on /diagnostics: its lines, and its estimate.
class SlamDiagnostics {
 public:
  /// Advertises the topic. `worker` and `lines` must outlive this object. The estimate is behind if
  /// lines of more than `window_s` wait for it.
  /// `base_laser` is null without one, and must outlive this object, too.
  SlamDiagnostics(const EstimateWorker& worker, double window_s, LineReport& lines,
                  const BaseLaserInput* base_laser);

  /// Takes note of the state of the estimate.
  void saw(const EstimateStatus& status) { status_ = status; }
  /// Publishes the present state, see publish_now().
  void publish();

 private:
  void trajectory(diagnostic_updater::DiagnosticStatusWrapper& report);

  const EstimateWorker& worker_;
  double window_s_;
  EstimateStatus status_;
  diagnostic_updater::Updater updater_;
};

}  // namespace ribbon_mapper::slam
