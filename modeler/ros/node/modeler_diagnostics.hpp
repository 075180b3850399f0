// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include "modeler/ros/node/line_report.hpp"
#include "modeler/ros/node/model_keeper.hpp"

namespace ribbon_mapper {

/// Reports the state of the modeler on /diagnostics: lines received, lines dropped by reason,
/// real-time factor and memory.
class ModelerDiagnostics {
 public:
  /// Advertises the topic. `keeper` and `lines` must outlive this object.
  ModelerDiagnostics(const ModelKeeper& keeper, LineReport& lines);
  /// Publishes the present state, see publish_now().
  void publish();

 private:
  void model(diagnostic_updater::DiagnosticStatusWrapper& status);

  const ModelKeeper& keeper_;
  diagnostic_updater::Updater updater_;
  std::size_t reports_ = 0, model_bytes_ = 0;
};

}  // namespace ribbon_mapper
