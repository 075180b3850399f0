// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/lines/line_times.hpp"

#include <numeric>

#include "bench/stopwatch.hpp"

namespace ribbon_mapper::bench {
namespace {

std::vector<double> medians(const std::vector<std::vector<double>>& runs) {
  std::vector<double> result(runs[0].size());
  std::vector<double> values(runs.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t run = 0; run < runs.size(); ++run) values[run] = runs[run][i];
    result[i] = median(values);
  }
  return result;
}

}  // namespace

double LineTimes::total_s() const { return std::accumulate(lines.begin(), lines.end(), 0.0); }

LineTimes feed(const Recording& tour, Modeler& modeler) {
  LineTimes times;
  times.lines.reserve(tour.lines.size());
  for (const RecordedLine& line : tour.lines) {
    LineResult result = LineResult::malformed;
    const double seconds =
        seconds_of([&] { result = modeler.add_scan_line(line.beams, line.poses); });
    times.lines.push_back(seconds);
    if (result == LineResult::modelled) times.modelled.push_back(seconds);
  }
  return times;
}

LineTimes median_line_times(const Recording& tour, const ModelerConfig& config, int repetitions) {
  std::vector<std::vector<double>> lines, modelled;
  for (int i = 0; i < repetitions; ++i) {
    Modeler modeler(config);
    LineTimes times = feed(tour, modeler);
    lines.push_back(std::move(times.lines));
    modelled.push_back(std::move(times.modelled));
  }
  return {medians(lines), medians(modelled)};
}

}  // namespace ribbon_mapper::bench
