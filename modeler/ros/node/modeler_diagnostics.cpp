// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/node/modeler_diagnostics.hpp"

#include <unistd.h>

#include <fstream>
#include <utility>

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

ModelerDiagnostics::ModelerDiagnostics(const ModelKeeper& keeper, const LineIntake& intake,
                                       const TransformBuffer& tf, std::string scan_topic)
    : keeper_(keeper), intake_(intake), tf_(tf), scan_topic_(std::move(scan_topic)) {
  updater_.setHardwareID("none");
  updater_.add("scan lines", this, &ModelerDiagnostics::lines);
  updater_.add("plane model", this, &ModelerDiagnostics::model);
}

void ModelerDiagnostics::publish() {
  constexpr double kMaxPeriod_s = 3600.0;
  if (ros::Time::now().toSec() + kMaxPeriod_s < ros::TIME_MAX.toSec()) updater_.force_update();
}

void ModelerDiagnostics::lines(DiagnosticStatusWrapper& status) {
  const LineLog& log = keeper_.log();
  const std::size_t lines = log.lines(), dropped = log.dropped_lines();
  if (lines == 0) {
    status.summary(DiagnosticStatus::WARN, "no scan on " + scan_topic_ + " yet");
  } else if (dropped > dropped_before_) {
    status.summary(DiagnosticStatus::WARN, "lines are dropped");
  } else if (log.lost() > lost_before_) {
    status.summary(DiagnosticStatus::WARN, "lines are lost before they come here");
  } else if (!intake_.waits_for().empty() && lines == lines_before_) {
    status.summary(DiagnosticStatus::WARN, "waiting: " + intake_.waits_for());
  } else {
    status.summary(DiagnosticStatus::OK, lines > lines_before_ ? "receiving" : "no new lines");
  }
  lines_before_ = lines, dropped_before_ = dropped, lost_before_ = log.lost();
  status.add("lines in", lines);
  status.add("lines waiting for tf", intake_.waiting());
  status.add("lines dropped", dropped);
  status.add("lines lost before they came (header.seq)", log.lost());
  status.add("gaps between lines", log.gaps());
  status.addf("time without lines in gaps [s]", "%.1f", log.silent_s());
  const TransformCounts& transforms = tf_.counts();
  status.add("transforms repeated", transforms.repeated);
  status.add("transforms not usable", transforms.refused);
  for (const auto& [reason, count] : log.dropped_by_reason())
    status.add("dropped: " + reason, count);
  for (const auto& [outcome, count] : log.handled_by_outcome()) status.add(outcome, count);
}

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
