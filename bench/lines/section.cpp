// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "bench/lines/line_times.hpp"
#include "bench/normals/three_lines.hpp"
#include "bench/recording/tour_recording.hpp"
#include "bench/sections.hpp"
#include "bench/stopwatch.hpp"

namespace ribbon_mapper::bench {
namespace {

constexpr double kRate_hz = 40.0;
const std::string kSection = "lines, points to associated ribbons";

Row row_of(const Recording& tour, const LineTimes& times, double solve_ns) {
  const double beam_ns = 1e9 * times.total_s() / static_cast<double>(tour.return_count());
  const double lasting_s = static_cast<double>(tour.lines.size()) / kRate_hz;
  const double middle_s = median(times.modelled), late_s = quantile(times.modelled, 0.999);
  char name[64], text[160];
  std::snprintf(name, sizeof name, "%zu beams at %.0f Hz", tour.lines.front().beams.ranges_m.size(),
                kRate_hz);
  std::snprintf(text, sizeof text,
                "%.2f eigen solves a beam; %.0f x real time; line %.0f us, p99.9 %.0f us (%.1f x)",
                beam_ns / solve_ns, lasting_s / times.total_s(), 1e6 * middle_s, 1e6 * late_s,
                late_s / middle_s);
  Row row{kSection, name, times.total_s(), beam_ns, {}, {}, text, {}};
  row.details = {{"lines", tour.lines.size()},
                 {"valid_beams", tour.return_count()},
                 {"solves_per_beam", beam_ns / solve_ns},
                 {"real_time_factor", lasting_s / times.total_s()},
                 {"line_median_s", middle_s},
                 {"line_p999_s", late_s},
                 {"line_max_s", quantile(times.modelled, 1.0)}};
  return row;
}

}  // namespace

void measure_lines(const Inputs& inputs, Report& report) {
  const auto covariances = covariances_of(sample_buffers(inputs.tour, inputs.config, 16));
  // The unit is measured before and after the lines: the machine's moods hit both.
  std::vector<double> solves;
  const auto solve = [&] { solves.push_back(eigen_solve_ns(covariances)); };
  for (int i = 0; i < 20; ++i) solve();
  const LineTimes times = median_line_times(inputs.tour, inputs.config, inputs.options.repetitions);
  for (int i = 0; i < 20; ++i) solve();
  const double solve_ns = median(solves);
  report.add({kSection, "one 3x3 eigen solve (computeDirect)", {}, solve_ns, {}, {}, "", {}});
  const Row row = row_of(inputs.tour, times, solve_ns);
  report.add(row);
  report.set("line_per_eigen", row.details["solves_per_beam"]);
  report.set("line_p999_over_median", quantile(times.modelled, 0.999) / median(times.modelled));
  report.set("real_time_factor_380", row.details["real_time_factor"]);
  for (const int beams : {720, 1040}) {
    Recording wide = recording_of(apartment_tour(beams), inputs.options.output);
    if (inputs.options.quick) wide = head_of(wide, 1000);
    const Row wide_row = row_of(wide, median_line_times(wide, inputs.config, 1), solve_ns);
    report.add(wide_row);
    report.set("real_time_factor_" + std::to_string(beams), wide_row.details["real_time_factor"]);
  }
}

}  // namespace ribbon_mapper::bench
