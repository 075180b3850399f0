// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <string>

#include "modeler/ros/intake/line_intake.hpp"
#include "modeler/ros/intake/transform_buffer.hpp"
#include "modeler/ros/node/model_keeper.hpp"

namespace ribbon_mapper {

/// Reports the state of the modeler on /diagnostics: lines received, lines dropped by reason,
/// real-time factor and memory.
class ModelerDiagnostics {
 public:
  /// Advertises the topic. `keeper`, `intake` and `tf` must outlive this object.
  ModelerDiagnostics(const ModelKeeper& keeper, const LineIntake& intake, const TransformBuffer& tf,
                     std::string scan_topic);
  /// Publishes the present state, unless the clock is so near to its end that the time of the next
  /// report cannot be told: diagnostic_updater throws then.
  void publish();

 private:
  void lines(diagnostic_updater::DiagnosticStatusWrapper& status);
  void model(diagnostic_updater::DiagnosticStatusWrapper& status);

  const ModelKeeper& keeper_;
  const LineIntake& intake_;
  const TransformBuffer& tf_;
  std::string scan_topic_;
  diagnostic_updater::Updater updater_;
  std::size_t lines_before_ = 0, dropped_before_ = 0, lost_before_ = 0;  ///< at the last report
  std::size_t reports_ = 0, model_bytes_ = 0;
};

}  // namespace ribbon_mapper
