// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/offline/offline_page.hpp"

#include "modeler/program/version.hpp"
#include "modeler/report/model_history.hpp"
#include "modeler/ros/bag_check/number_text.hpp"

namespace ribbon_mapper {
namespace {

/// Returns the names of the bags as a title.
std::string title_of(const OfflineSummary& summary) {
  std::string title;
  for (const std::string& bag : summary.bags) title += (title.empty() ? "" : ", ") + bag;
  return title.empty() ? "Model of a recording" : title;
}

void add_lines(const OfflineSummary& s, Report& report) {
  report.add_fact("Lines", std::to_string(s.lines) + ", " + std::to_string(dropped_total(s)) +
                               " of them dropped");
  for (const auto& [reason, count] : s.dropped_lines) {
    report.add_fact("Dropped", std::to_string(count) + " x " + reason);
  }
  for (const auto& [outcome, count] : s.handled_lines) {
    report.add_fact("Handled", std::to_string(count) + " x " + outcome);
  }
}

void add_facts(const OfflineSummary& s, Report& report) {
  report.add_fact("Preset", s.config);
  report.add_fact("Scans", s.scan_topic);
  report.add_fact("Poses", s.trajectory);
  add_lines(s, report);
  report.add_fact("Ribbons", std::to_string(s.ribbons));
  report.add_fact("Duplicates", std::to_string(s.duplicates));
  if (s.residual_m_median) {
    report.add_fact("Median residual", number(1e3 * *s.residual_m_median, 2) + " mm");
  }
  report.add_fact("Recording", number(s.recording_s, 1) + " s");
  if (s.wall_s > 0.0) {
    report.add_fact("Computing time", number(s.wall_s, 2) + " s, " +
                                          number(real_time_factor(s), 0) + " times real time");
    report.add_fact("Peak memory", number(s.peak_memory_mib, 0) + " MiB");
  }
  for (const std::string& note : s.notes) report.add_fact("Note", note);
}

}  // namespace

std::string offline_page(const OfflineRun& run, const std::string& run_id) {
  ReportHead head;
  head.title = title_of(run.summary);
  head.frame = run.frame;
  head.run = run_id;
  head.version = "ribbon_mapper " + version();
  head.command = run.command;
  head.parameters = run.summary.parameters;
  Report report =
      report_of(head, {"recorded poses, as built", &run.planes_before, run.trajectory_before,
                       "final", &run.planes_after, run.trajectory, run.labels, run.rooms});
  add_facts(run.summary, report);
  return report.html();
}

}  // namespace ribbon_mapper
