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

const std::string kSection = "lines, points to associated ribbons";

/// Times per valid beam. Lines that do not enter the model are cheap, and many if the laser rests.
struct BeamTimes {
  double all_ns = 0.0, modelled_ns = 0.0;  ///< of all lines, and of those that entered the model
  std::size_t beams = 0;                   ///< number of valid beams
};

BeamTimes beam_times_of(const Recording& recording, const ScanConfig& config,
                        const LineTimes& times) {
  const std::vector<std::size_t> returns = returns_of(recording, config);
  std::size_t all = 0, of_modelled = 0;
  double modelled_s = 0.0;
  for (std::size_t i = 0; i < returns.size(); ++i) {
    all += returns[i];
    if (times.results[i] != LineResult::modelled) continue;
    of_modelled += returns[i];
    modelled_s += times.lines[i];
  }
  return {1e9 * times.total_s() / static_cast<double>(all),
          1e9 * modelled_s / static_cast<double>(of_modelled), all};
}

Row row_of(const Recording& recording, const ScanConfig& config, const LineTimes& times,
           double solve_ns) {
  const BeamTimes beam = beam_times_of(recording, config, times);
  const std::vector<double> modelled = times.modelled();
  const double middle_s = median(modelled), late_s = quantile(modelled, 0.999);
  char name[64], text[192];
  std::snprintf(name, sizeof name, "%zu beams at %.3g Hz",
                recording.lines.front().beams.ranges_m.size(),
                static_cast<double>(recording.lines.size()) / recording.duration_s);
  std::snprintf(
      text, sizeof text,
      "%.2f eigen solves a beam, %.2f in lines that are modelled (%.0f %%); %.0f x real "
      "time; line %.0f us, p99.9 %.0f us (%.1f x)",
      beam.all_ns / solve_ns, beam.modelled_ns / solve_ns,
      100.0 * static_cast<double>(modelled.size()) / static_cast<double>(times.lines.size()),
      recording.duration_s / times.total_s(), 1e6 * middle_s, 1e6 * late_s, late_s / middle_s);
  Row row{kSection, name, times.total_s(), beam.all_ns, {}, {}, text, {}};
  row.details = {{"lines", times.lines.size()},
                 {"modelled_lines", modelled.size()},
                 {"valid_beams", beam.beams},
                 {"solves_per_beam", beam.all_ns / solve_ns},
                 {"solves_per_modelled_beam", beam.modelled_ns / solve_ns},
                 {"real_time_factor", recording.duration_s / times.total_s()},
                 {"line_median_s", middle_s},
                 {"line_p999_s", late_s},
                 {"line_p999_over_median", late_s / middle_s},
                 {"line_max_s", quantile(modelled, 1.0)}};
  return row;
}

/// Returns the unit [ns], measured before and after `work` because the machine's speed may vary.
template <typename Work>
double solve_ns_around(const Inputs& inputs, const Work& work) {
  const auto covariances = covariances_of(sample_lines(inputs.recording, inputs.config, 16));
  std::vector<double> solves;
  const auto solve = [&] { solves.push_back(eigen_solve_ns(covariances)); };
  for (int i = 0; i < 20; ++i) solve();
  work();
  for (int i = 0; i < 20; ++i) solve();
  return median(solves);
}

/// Adds the rows of a recording and returns the unit [ns].
double measure_own_lines(const Inputs& inputs, const std::string& factor, Report& report) {
  LineTimes times;
  const double solve_ns = solve_ns_around(inputs, [&] {
    times = median_line_times(inputs.recording, inputs.config,
                              inputs.options.repetitions * repetitions_factor(inputs.recording));
  });
  report.add({kSection, "one 3x3 eigen solve (computeDirect)", {}, solve_ns, {}, {}, "", {}});
  const Row row = row_of(inputs.recording, inputs.config.scan, times, solve_ns);
  report.add(row);
  report.set("line_per_eigen", row.details["solves_per_beam"]);
  report.set("line_per_eigen_modelled", row.details["solves_per_modelled_beam"]);
  report.set("line_p999_over_median", row.details["line_p999_over_median"]);
  report.set(factor, row.details["real_time_factor"]);
  return solve_ns;
}

}  // namespace

void measure_recorded_lines(const Inputs& inputs, Report& report) {
  measure_own_lines(inputs, "real_time_factor", report);
}

void measure_lines(const Inputs& inputs, Report& report) {
  const double solve_ns = measure_own_lines(inputs, "real_time_factor_380", report);
  for (const int beams : {720, 1040}) {
    Recording wide = recording_of(apartment_tour(beams), inputs.options.output);
    if (inputs.options.quick) wide = head_of(wide, 1000);
    const Row row =
        row_of(wide, inputs.config.scan, median_line_times(wide, inputs.config, 1), solve_ns);
    report.add(row);
    report.set("real_time_factor_" + std::to_string(beams), row.details["real_time_factor"]);
  }
}

}  // namespace ribbon_mapper::bench
