// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/summary.hpp"

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace ribbon_mapper::eval {
namespace {

using Json = nlohmann::ordered_json;

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
          {"angle_error_deg_mean", to_json(m.angle_error_deg_mean)},
          {"offset_error_m_mean", to_json(m.offset_error_m_mean)}};
}

Json to_json(const FourCells& cells) {
  return {{"noisy_raw", to_json(cells.noisy_raw)},
          {"noisy_merged", to_json(cells.noisy_merged)},
          {"corrected_raw", to_json(cells.corrected_raw)},
          {"corrected_merged", to_json(cells.corrected_merged)}};
}

template <typename... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  std::array<char, 512> line;
  std::snprintf(line.data(), line.size(), pattern, arguments...);
  return line.data();
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

}  // namespace

std::string summary_to_json(const Summary& s) {
  const MapMetrics& result = s.cells.corrected_merged;
  Json json{{"world", s.world},
            {"route", s.route},
            {"seed", s.seed},
            {"drift", s.drift},
            {"lines", s.lines},
            {"dropped_lines", s.dropped_lines},
            {"ribbons", s.ribbons},
            {"truth_planes", result.truth},
            {"planes_noisy_raw", s.cells.noisy_raw.planes},
            {"planes_noisy_merged", s.cells.noisy_merged.planes},
            {"planes_corrected_raw", s.cells.corrected_raw.planes},
            {"planes_corrected_merged", result.planes}};
  Json metrics = to_json(result);
  metrics.erase("planes");
  json.update(metrics);
  json.update({{"end_drift_m", s.end_drift_m},
               {"end_drift_deg", s.end_drift_deg},
               {"us_per_line", s.us_per_line},
               {"correction_ms", s.correction_ms},
               {"real_time_factor", s.real_time_factor},
               {"four_cells", to_json(s.cells)},
               {"command", s.command},
               {"version", RIBBON_MAPPER_VERSION}});
  return json.dump(2) + "\n";
}

std::string summary_table(const Summary& s) {
  return format("%-32s %6s %8s %7s %6s %11s %6s %9s %10s %11s\n", "trajectory, model", "planes",
                "matched", "missed", "extra", "duplicates", "f1", "covered %", "angle deg",
                "offset mm") +
         table_row("noisy, as built", s.cells.noisy_raw) +
         table_row("noisy, merged and filtered", s.cells.noisy_merged) +
         table_row("corrected, as built", s.cells.corrected_raw) +
         table_row("corrected, merged and filtered", s.cells.corrected_merged) +
         format("%-32s %6zu\n\n", "truth", s.cells.corrected_merged.truth) +
         format(
             "%zu lines (%zu dropped), %zu ribbons, %.0f us per line, %.1f x real time; the robot "
             "ended %.2f m and %.1f deg off; corrected in %.0f ms\n",
             s.lines, s.dropped_lines, s.ribbons, s.us_per_line, s.real_time_factor, s.end_drift_m,
             s.end_drift_deg, s.correction_ms);
}

}  // namespace ribbon_mapper::eval
