// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/node/modeler_diagnostics.hpp"

#include <unistd.h>

#include <fstream>

#include "modeler/ros/node/update_of_diagnostics.hpp"

namespace ribbon_mapper {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

double megabytes(double bytes) { return bytes / 1e6; }

/// Returns the resident memory of this process; 0 where /proc is missing.
double resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  double all_pages = 0.0, resident_pages = 0.0;
  statm >> all_pages >> resident_pages;
  return resident_pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

ModelerDiagnostics::ModelerDiagnostics(const ModelKeeper& keeper, LineReport& lines)
    : keeper_(keeper) {
  updater_.setHardwareID("none");
  updater_.add("scan lines", &lines, &LineReport::diagnose);
  updater_.add("plane model", this, &ModelerDiagnostics::model);
}

void ModelerDiagnostics::publish() { publish_now(updater_); }

void ModelerDiagnostics::model(DiagnosticStatusWrapper& status) {
  const ModelStatistics statistics = keeper_.modeler().statistics();
  const double factor = keeper_.real_time_factor();
  const bool slow = factor > 0.0 && factor < 1.0;
  status.summary(slow ? DiagnosticStatus::WARN : DiagnosticStatus::OK,
                 slow ? "slower than the laser" : "running");
  status.add("ribbons", statistics.ribbons);
  if (statistics.thinned > 0) status.add("ribbons left out (map.max_ribbons)", statistics.thinned);
  status.add("corrections", statistics.revision);
  status.addf("real-time factor", "%.1f", factor);
  status.addf("median time of a line [us]", "%.0f", keeper_.log().median_line_us());
  status.addf("last correction [ms]", "%.1f", keeper_.correction_ms());
  if (reports_++ % 10 == 0)
    model_bytes_ = keeper_.modeler().memory_bytes();  // slow, so not each time
  status.addf("model [MB]", "%.1f", megabytes(static_cast<double>(model_bytes_)));
  status.addf("process [MB]", "%.1f", megabytes(resident_bytes()));
}

}  // namespace ribbon_mapper
