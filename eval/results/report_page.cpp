// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/report_page.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "eval/results/format.hpp"
#include "modeler/geometry/angles.hpp"
#include "modeler/program/version.hpp"
#include "modeler/report/model_history.hpp"
#include "modeler/report/report.hpp"

namespace ribbon_mapper::eval {
namespace {

using Row = std::vector<std::string>;

/// Returns what the truth says of each plane of a model.
std::vector<PlaneRemarks> remarks_on(const std::vector<Plane>& planes, const MapMetrics& metrics,
                                     const std::vector<Plane>& truth) {
  std::vector<PlaneRemarks> remarks(planes.size());
  for (PlaneRemarks& remark : remarks) remark.verdict = PlaneVerdict();
  for (const std::size_t i : metrics.duplicates) {
    remarks.at(i).verdict->kind = PlaneVerdict::Kind::duplicate;
  }
  for (const Match& match : metrics.matches) {
    const Plane& plane = planes.at(match.estimate);
    const Plane& surface = truth.at(match.truth);
    const double angle_rad =
        std::atan2(plane.normal.cross(surface.normal).norm(), plane.normal.dot(surface.normal));
    remarks[match.estimate].verdict =
        PlaneVerdict{PlaneVerdict::Kind::matched, match.truth, to_degrees(angle_rad),
                     surface.normal.dot(plane.centroid) + surface.d_m};
  }
  return remarks;
}

std::string or_dash(const std::optional<double>& value, double scale, int decimals) {
  return value ? format("%.*f", decimals, *value * scale) : "-";
}

Row row_of(const char* name, const MapMetrics& m) {
  return {name,
          std::to_string(m.planes),
          std::to_string(m.matched),
          std::to_string(m.missed.size()),
          std::to_string(m.extra.size()),
          std::to_string(m.duplicates.size()),
          format("%.3f", m.f1),
          format("%.1f", 100.0 * m.coverage),
          or_dash(m.outline_iou, 1.0, 3),
          or_dash(m.angle_error_deg_mean, 1.0, 2),
          or_dash(m.offset_error_m_mean, 1000.0, 1)};
}

Row row_of(const char* name, const PointMetrics& m) {
  const SegComp& s = m.segcomp;
  return {name,
          std::to_string(s.correct),
          std::to_string(s.over),
          std::to_string(s.under),
          std::to_string(s.missed.size()),
          std::to_string(s.noise.size()),
          format("%.3f", m.evops.f1),
          format("%.1f", 100.0 * s.correct_points_share),
          format("%.1f", 100.0 * s.correct_share),
          std::to_string(m.duplication.duplicates)};
}

template <typename Metrics>
std::vector<Row> rows_of(const PerModel<Metrics>& metrics) {
  return {row_of("noisy trajectory, as built", metrics.noisy_as_built),
          row_of("noisy trajectory, final", metrics.noisy),
          row_of("corrected trajectory, as built", metrics.corrected_as_built),
          row_of("corrected trajectory, final", metrics.corrected)};
}

void add_tables(const Summary& s, Report& report) {
  report.add_table({"Planes of the four models against the truth (" +
                        std::to_string(s.metrics.corrected.truth) + " true planes)",
                    {"model", "planes", "matched", "missed", "extra", "duplicates", "F1",
                     "covered [%]", "outline IoU", "angle error [°]", "offset error [mm]"},
                    rows_of(s.metrics)});
  if (!s.points) return;
  report.add_table({"The same by points (SegComp, EVOPS)",
                    {"model", "correct", "over", "under", "missed", "noise", "F1",
                     "points right [%]", "planes right [%]", "duplicates"},
                    rows_of(*s.points)});
}

void add_facts(const Summary& s, Report& report) {
  report.add_fact("World", s.run.world);
  report.add_fact("Drift", format("%g times gmapping's", s.run.drift));
  report.add_fact("Seed", std::to_string(s.run.seed));
  report.add_fact("Corrected by",
                  s.run.closure == "self" ? "an estimate without truth" : "the true trajectory");
  report.add_fact("Lines", format("%zu, %zu of them dropped", s.lines, s.dropped_lines));
  report.add_fact("Ribbons", std::to_string(s.ribbons));
  report.add_fact("Drift at the end", format("%.2f m and %.1f°", s.end_drift_m, s.end_drift_deg));
  report.add_fact("Computing time", format("%.0f µs per line, %.1f times real time", s.us_per_line,
                                           s.real_time_factor));
  report.add_fact("Correction", format("%.0f ms", s.correction_ms));
  if (!s.estimate) return;
  report.add_fact("Error of the estimated trajectory",
                  format("%.1f cm and %.2f° (RMS)", 100.0 * s.estimate->error.rmse_m,
                         s.estimate->error.rmse_deg));
}

}  // namespace

std::string report_page(const Results& results, const std::vector<Plane>& before,
                        const std::vector<Plane>& truth, const std::string& run_id) {
  const Summary& s = results.summary;
  ReportHead head;
  head.title =
      std::filesystem::path(s.run.world).stem().string() + ": before and after the correction";
  head.run = run_id;
  head.version = "ribbon_mapper " + version();
  head.command = s.command;
  head.parameters = results.parameters;
  Report report(head);
  report.add_trajectory("before the correction", results.trajectory_before);
  report.add_trajectory("after the correction", results.trajectory_after);
  const auto& models = results.models;
  const auto& metrics = s.metrics;
  report.add_model(
      {"before, as built", &before, remarks_on(before, metrics.noisy_as_built, truth)});
  report.add_model(
      {"before, final", &models.noisy, remarks_on(models.noisy, metrics.noisy, truth)});
  std::vector<PlaneRemarks> remarks = remarks_on(models.corrected, metrics.corrected, truth);
  for (std::size_t i = 0; i < std::min(remarks.size(), results.labels.size()); ++i) {
    remarks[i].label = results.labels[i].text;
  }
  report.add_model({"after", &models.corrected, remarks, 1});
  if (results.rooms) add_rooms(*results.rooms, report);
  report.set_truth(truth, results.trajectory_truth);
  add_tables(s, report);
  add_facts(s, report);
  return report.html();
}

}  // namespace ribbon_mapper::eval
