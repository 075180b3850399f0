// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/node/slam_diagnostics.hpp"

#include "modeler/ros/node/update_of_diagnostics.hpp"

namespace ribbon_mapper::slam {
namespace {

using diagnostic_msgs::DiagnosticStatus;

std::string text_of(const std::optional<Decision>& decision) {
  if (!decision) return "none";
  return name_of(decision->kind) + ": " + decision->reason;
}

}  // namespace

SlamDiagnostics::SlamDiagnostics(const EstimateWorker& worker, double window_s, LineReport& lines,
                                 const BaseLaserInput* base_laser)
    : worker_(worker), window_s_(window_s) {
  updater_.setHardwareID("none");
  updater_.add("scan lines", &lines, &LineReport::diagnose);
  updater_.add("trajectory", this, &SlamDiagnostics::trajectory);
  if (base_laser == nullptr) return;
  updater_.add("base laser", [this, base_laser](auto& report) {
    base_laser->diagnose(status_.base_scans, report);
  });
}

void SlamDiagnostics::publish() { publish_now(updater_); }

void SlamDiagnostics::trajectory(diagnostic_updater::DiagnosticStatusWrapper& report) {
  const double behind_s = worker_.seconds_behind();
  if (status_.is_lost) {
    report.summary(DiagnosticStatus::WARN, "lost: " + text_of(status_.latest_decision));
  } else if (behind_s > window_s_) {
    report.summary(DiagnosticStatus::WARN, "slower than the laser");
  } else {
    report.summary(DiagnosticStatus::OK, status_.lines > 0 ? "running" : "no poses yet");
  }
  report.add("poses", status_.lines);
  report.add("lines behind", worker_.lines_behind());
  report.addf("time behind [s]", "%.1f", behind_s);
  report.add("lost", status_.is_lost ? "yes" : "no");
  report.add("decisions", status_.decisions);
  report.add("latest decision", text_of(status_.latest_decision));
  report.addf("noise of odometry [x gmapping's]", "%.2f", status_.noise_scale);
  report.add("windows", status_.windows);
  report.addf("last window [ms]", "%.0f", 1e3 * status_.window_s);
  report.addf("longest window [ms]", "%.0f", 1e3 * status_.longest_window_s);
  report.addf("last whole adjustment [ms]", "%.0f", 1e3 * status_.adjustment_s);
}

}  // namespace ribbon_mapper::slam
