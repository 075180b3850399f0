// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/report/model_history.hpp"

namespace ribbon_mapper {

Report report_of(const ReportHead& head, const ModelHistory& history) {
  Report report(head);
  std::size_t trajectory = 0;
  if (history.planes_before != nullptr) {
    report.add_trajectory(history.name_before, history.trajectory_before);
    report.add_model({history.name_before, history.planes_before, {}, trajectory++});
  }
  report.add_trajectory(history.name, history.trajectory);
  report.add_model({history.name, history.planes, {}, trajectory});
  return report;
}

}  // namespace ribbon_mapper
