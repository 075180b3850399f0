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

std::vector<double> LineTimes::modelled() const {
  std::vector<double> times;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (results[i] == LineResult::modelled) times.push_back(lines[i]);
  }
  return times;
}

LineTimes feed(const Recording& tour, Modeler& modeler) {
  LineTimes times;
  times.lines.reserve(tour.lines.size());
  times.results.reserve(tour.lines.size());
  for (const RecordedLine& line : tour.lines) {
    LineResult result = LineResult::malformed;
    times.lines.push_back(
        cpu_seconds_of([&] { result = modeler.add_scan_line(line.beams, line.poses); }));
    times.results.push_back(result);
  }
  return times;
}

LineTimes median_line_times(const Recording& tour, const ModelerConfig& config, int repetitions) {
  LineTimes times;
  std::vector<std::vector<double>> lines;
  for (int i = 0; i < repetitions; ++i) {
    Modeler modeler(config);
    times = feed(tour, modeler);  // the same results each time
    lines.push_back(std::move(times.lines));
  }
  times.lines = medians(lines);
  return times;
}

}  // namespace ribbon_mapper::bench
