// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/summary.hpp"

#include "eval/results/format.hpp"
#include "eval/results/label_report.hpp"
#include "modeler/program/version.hpp"
#include "modeler/text/ordered_json.hpp"

namespace ribbon_mapper::eval {
namespace {

Json to_json(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json to_json(const MapMetrics& m) {
  return {{"planes", m.planes},
          {"matched", m.matched},
          {"missed", m.missed.size()},
          {"extra", m.extra.size()},
          {"duplicates", m.duplicates.size()},
          {"precision", m.precision},
          {"recall", m.recall},
          {"f1", m.f1},
          {"coverage", m.coverage},
          {"outline_iou", to_json(m.outline_iou)},
          {"duplication_ratio", to_json(m.duplication_ratio)},
          {"angle_error_deg_mean", to_json(m.angle_error_deg_mean)},
          {"angle_error_deg_median", to_json(m.angle_error_deg_median)},
          {"offset_error_m_mean", to_json(m.offset_error_m_mean)},
          {"offset_error_m_median", to_json(m.offset_error_m_median)}};
}

Json to_json(const SegComp& s) {
  return {{"correct", s.correct},
          {"over", s.over},
          {"under", s.under},
          {"missed", s.missed.size()},
          {"noise", s.noise.size()},
          {"correct_share", s.correct_share},
          {"correct_points_share", s.correct_points_share}};
}

Json to_json(const Evops& e) {
  return {{"matched", e.matched},
          {"precision", e.precision},
          {"recall", e.recall},
          {"f1", e.f1},
          {"under_segmented", e.under_segmented},
          {"over_segmented", e.over_segmented},
          {"noise", e.noise},
          {"missed", e.missed}};
}

/// Returns the metrics of one model, by planes and, where beams have labels, by points.
Json model_to_json(const MapMetrics& planes, const PointMetrics* points) {
  Json json = to_json(planes);
  json["segcomp"] = points ? to_json(points->segcomp) : Json(nullptr);
  json["evops"] = points ? to_json(points->evops) : Json(nullptr);
  json["point_duplicates"] = points ? Json(points->duplication.duplicates) : Json(nullptr);
  json["point_duplication_ratio"] = points ? to_json(points->duplication.ratio) : Json(nullptr);
  json["segcomp_all"] = points ? to_json(points->segcomp_all) : Json(nullptr);
  return json;
}

Json four_models_to_json(const Summary& s) {
  const PerModel<PointMetrics>* p = s.points ? &*s.points : nullptr;
  return {
      {"noisy_as_built", model_to_json(s.metrics.noisy_as_built, p ? &p->noisy_as_built : nullptr)},
      {"noisy", model_to_json(s.metrics.noisy, p ? &p->noisy : nullptr)},
      {"corrected_as_built",
       model_to_json(s.metrics.corrected_as_built, p ? &p->corrected_as_built : nullptr)},
      {"corrected", model_to_json(s.metrics.corrected, p ? &p->corrected : nullptr)}};
}

std::string or_dash(const std::optional<double>& value, double scale, int decimals) {
  return value ? format("%.*f", decimals, *value * scale) : "-";
}

std::string table_row(const char* name, const MapMetrics& m) {
  return format("%-32s %6zu %8zu %7zu %6zu %11zu %6.3f %9.1f %10s %11s\n", name, m.planes,
                m.matched, m.missed.size(), m.extra.size(), m.duplicates.size(), m.f1,
                100.0 * m.coverage, or_dash(m.angle_error_deg_mean, 1.0, 2).c_str(),
                or_dash(m.offset_error_m_mean, 1000.0, 1).c_str());
}

std::string table_row(const char* name, const PointMetrics& m) {
  const SegComp& s = m.segcomp;
  return format("%-32s %6zu %8zu %7zu %6zu %11zu %6.3f %9.1f %10.1f %11zu\n", name, s.correct,
                s.over, s.under, s.missed.size(), s.noise.size(), m.evops.f1,
                100.0 * s.correct_points_share, 100.0 * s.correct_share, m.duplication.duplicates);
}

template <typename Metrics>
std::string table_rows(const PerModel<Metrics>& metrics) {
  return table_row("noisy, as built", metrics.noisy_as_built) +
         table_row("noisy, final", metrics.noisy) +
         table_row("corrected, as built", metrics.corrected_as_built) +
         table_row("corrected, final", metrics.corrected);
}

std::string points_table(const PerModel<PointMetrics>& points) {
  return format("\n%-32s %6s %8s %7s %6s %11s %6s %9s %10s %11s\n", "by points (SegComp, EVOPS)",
                "correct", "over", "under", "missed", "noise", "f1", "points %", "planes %",
                "duplicates") +
         table_rows(points);
}

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

template <typename Value>
Json value_or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json to_json(const RunOptions& run) {
  Json json{{"world", run.world},
            {"route", run.route},
            {"config", text_or_null(run.config)},
            {"noise", text_or_null(run.noise)},
            {"tilt", text_or_null(run.tilt)},
            {"closure", text_or_null(run.closure)},
            {"caster", text_or_null(run.caster)},
            {"beams", value_or_null(run.beams)},
            {"rate_hz", value_or_null(run.rate_hz)},
            {"speed_m_s", value_or_null(run.speed_m_s)},
            {"deskew", value_or_null(run.deskew)},
            {"drift", run.drift},
            {"seed", run.seed}};
  if (run.base_laser) json["base_laser"] = true;
  if (run.visuals) json["visuals"] = true;
  if (!run.odometry_faults.empty()) json["odometry_faults"] = run.odometry_faults;
  return json;
}

Json times_of(const Summary& s) {
  Json json{{"us_per_line", s.us_per_line},
            {"correction_ms", s.correction_ms},
            {"real_time_factor", s.real_time_factor}};
  if (s.estimate && s.estimate->report) {
    const EstimateReport& estimate = *s.estimate->report;
    json["estimate_updates_s"] = estimate.updates_s;
    json["estimate_longest_update_s"] = estimate.longest_update_s;
    json["estimate_finish_s"] = estimate.finish_s;
    json["estimate_covariances_s"] = estimate.covariances_s;
  }
  return json;
}

Json to_json(const TrajectoryError& error) {
  return {{"rmse_m", error.rmse_m},
          {"largest_m", error.largest_m},
          {"rmse_deg", error.rmse_deg},
          {"aligned_rmse_m", error.aligned_rmse_m}};
}

Json to_json(const EstimateSummary& estimate) {
  Json json = to_json(estimate.error);
  if (!estimate.report) return json;
  json["live"] = to_json(estimate.report->live);
  for (const auto& [name, sigma] : named_sigmas(estimate.report->precision)) json[name] = sigma;
  json["nees"] = estimate.report->nees;
  json["noise_scale"] = estimate.report->noise_scale;
  json["decisions"] = estimate.report->decisions;
  return json;
}

std::string report_text(const EstimateReport& report) {
  return format(
      "; live %.1f cm RMS (largest %.1f); known to %.1f cm and %.2f deg (median; NEES %.2f); "
      "odometry %.1f x gmapping's noise; "
      "%.1f s for all lines (longest %.0f ms), %.1f s at the end",
      100.0 * report.live.rmse_m, 100.0 * report.live.largest_m,
      100.0 * report.precision.position_m_median, report.precision.heading_deg_median, report.nees,
      report.noise_scale, report.updates_s, 1e3 * report.longest_update_s, report.finish_s);
}

std::string estimate_text(const EstimateSummary& estimate) {
  const TrajectoryError& e = estimate.error;
  return format(
             "trajectory estimated without truth: position %.1f cm RMS (largest %.1f; aligned "
             "%.1f), heading %.2f deg",
             100.0 * e.rmse_m, 100.0 * e.largest_m, 100.0 * e.aligned_rmse_m, e.rmse_deg) +
         (estimate.report ? report_text(*estimate.report) : "") + "\n";
}

/// Returns the figures without the times.
Json figures_of(const Summary& s) {
  const MapMetrics& result = s.metrics.corrected;
  Json json{{"lines", s.lines},
            {"dropped_lines", s.dropped_lines},
            {"ribbons", s.ribbons},
            {"truth_planes", result.truth},
            {"planes_noisy_as_built", s.metrics.noisy_as_built.planes},
            {"planes_noisy", s.metrics.noisy.planes},
            {"planes_corrected_as_built", s.metrics.corrected_as_built.planes},
            {"planes_corrected", result.planes}};
  Json metrics = to_json(result);
  metrics.erase("planes");
  json.update(metrics);
  json.update({{"ribbon_angle_deg", to_json(s.ribbon_angle_deg)},
               {"ribbon_distance_m", to_json(s.ribbon_distance_m)},
               {"end_drift_m", s.end_drift_m},
               {"end_drift_deg", s.end_drift_deg}});
  json["labels"] = s.labels ? label_json(*s.labels) : Json(nullptr);
  if (s.estimate) json["estimate"] = to_json(*s.estimate);
  return json;
}

}  // namespace

std::string summary_to_json(const Summary& s, const std::string& run_id) {
  Json json = to_json(s.run);
  if (!run_id.empty()) json["run"] = run_id;
  json.update(figures_of(s));
  json.update(times_of(s));
  json.update(
      {{"four_models", four_models_to_json(s)}, {"command", s.command}, {"version", version()}});
  return json.dump(2) + "\n";
}

std::string run_line(const Summary& s, const std::string& inputs) {
  Json json = to_json(s.run);
  json.update(figures_of(s));
  json.update({{"four_models", four_models_to_json(s)},
               {"command", s.command},
               {"inputs", inputs},
               {"version", version()}});
  return json.dump() + "\n";
}

std::string timing_line(const Summary& s) {
  Json json = to_json(s.run);
  json.update(times_of(s));
  return json.dump() + "\n";
}

std::string summary_table(const Summary& s) {
  return format("%-32s %6s %8s %7s %6s %11s %6s %9s %10s %11s\n", "trajectory, model", "planes",
                "matched", "missed", "extra", "duplicates", "f1", "covered %", "angle deg",
                "offset mm") +
         table_rows(s.metrics) + format("%-32s %6zu\n", "truth", s.metrics.corrected.truth) +
         (s.points ? points_table(*s.points) : "") +
         (s.labels ? "\n" + label_table(*s.labels) : "") +
         format(
             "\n%zu lines (%zu dropped), %zu ribbons, %.0f us per line, %.1f x real time; end "
             "drift "
             "%.2f m and %.1f deg; corrected in %.0f ms\n",
             s.lines, s.dropped_lines, s.ribbons, s.us_per_line, s.real_time_factor, s.end_drift_m,
             s.end_drift_deg, s.correction_ms) +
         (s.estimate ? estimate_text(*s.estimate) : "");
}

}  // namespace ribbon_mapper::eval
