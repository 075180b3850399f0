// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <stdexcept>

#include "bench/child.hpp"
#include "bench/lines/line_times.hpp"
#include "bench/planes/judge.hpp"
#include "bench/scale/office.hpp"
#include "bench/scale/tiles.hpp"
#include "bench/sections.hpp"
#include "bench/stopwatch.hpp"

namespace ribbon_mapper::bench {
namespace {

constexpr double kSpacing_m = 40.0;  // more than any ribbon reaches

template <typename... Values>
std::string formatted(const char* format, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

double total_area_m2(const std::vector<Plane>& planes) {
  double sum = 0.0;
  for (const Plane& plane : planes) sum += plane.area_m2;
  return sum;
}

/// Two periods of the tilt in the flat, in more and more places.
void lines_over_planes(const Inputs& inputs, Report& report) {
  Recording piece = inputs.tour;
  const auto middle = piece.lines.begin() + static_cast<std::ptrdiff_t>(piece.lines.size() / 2);
  piece.lines = std::vector<RecordedLine>(middle, middle + 240);
  const Tiles tiles(piece, kSpacing_m, 33);
  Modeler modeler(inputs.config);
  constexpr std::size_t kMeasured = 5;  // tiles around each number
  const std::vector<std::size_t> numbers =
      inputs.options.quick ? std::vector<std::size_t>{3, 30, 100}
                           : std::vector<std::size_t>{3, 10, 30, 100, 300, 1000};
  std::vector<double> x, y;
  std::size_t fed = 0, planes_of_place = 0;
  for (const std::size_t number : numbers) {
    std::vector<double> seconds;
    for (; fed < number + kMeasured / 2; ++fed) {
      const double mean_s = tiles.feed(fed, modeler);
      if (fed + 1 + kMeasured / 2 >= number) seconds.push_back(mean_s);
    }
    x.push_back(static_cast<double>(number));
    y.push_back(median(seconds));
    if (planes_of_place == 0) planes_of_place = modeler.planes().size() / fed;
    const std::size_t ribbons = modeler.statistics().ribbons;
    report.add(
        {"growth: time of a line over planes",
         formatted("%zu places", number),
         y.back(),
         {},
         y.back() / y.front(),
         {},
         formatted("about %zu planes as built, %zu ribbons", number * planes_of_place, ribbons),
         {{"places", number}, {"ribbons", ribbons}}});
  }
  report.set("line_growth_exponent", fitted_exponent(x, y));
}

/// CPU seconds of a correction with the planes that come of it.
double correction_s(Modeler& modeler, const std::vector<StampedPose>& trajectory,
                    std::vector<Plane>& planes) {
  return seconds_of([&] {
    modeler.correct(trajectory);
    planes = modeler.merged_planes();
  });
}

nlohmann::json corrections_of(const Inputs& inputs, std::size_t number) {
  const Tiles tiles(inputs.tour, kSpacing_m, 6);
  Modeler modeler(inputs.config);
  for (std::size_t k = 0; k < number; ++k) tiles.feed(k, modeler);
  const auto truth = tiles.truth(number);
  const auto tenth = bent(truth, 0.1), all = bent(truth, 1.0);
  std::vector<Plane> planes;
  nlohmann::json result;
  result["seconds"] = correction_s(modeler, truth, planes);
  result["planes"] = planes.size();
  result["area_m2"] = total_area_m2(planes);
  result["bytes"] = modeler.memory_bytes();
  result["ribbons"] = modeler.statistics().ribbons;
  result["tenth_s"] = correction_s(modeler, tenth, planes);
  result["all_s"] = correction_s(modeler, all, planes);
  return result;
}

/// The whole tour in more and more places, up to a million ribbons.
void correction_over_ribbons(const Inputs& inputs, Report& report) {
  const std::vector<std::size_t> numbers = inputs.options.quick
                                               ? std::vector<std::size_t>{1, 3}
                                               : std::vector<std::size_t>{1, 3, 10, 34};
  std::vector<double> x, y;
  for (const std::size_t number : numbers) {
    const auto run =
        run_in_child([&] { return corrections_of(inputs, number); }, inputs.options.limit_s);
    if (!run) throw std::runtime_error("a correction took longer than the limit of CPU time");
    const nlohmann::json& result = run->value;
    x.push_back(result["ribbons"]);
    y.push_back(result["seconds"]);
    const double tenth_over_all = result["tenth_s"].get<double>() / result["all_s"].get<double>();
    const double bytes_per_m2 = result["bytes"].get<double>() / result["area_m2"].get<double>();
    report.add({"growth: correction and planes over ribbons",
                formatted("%.0f ribbons", x.back()),
                y.back(),
                1e9 * y.back() / x.back(),
                {},
                run->peak_mb,
                formatted("%d planes, %.0f bytes per m2; a tenth moved: %.2f of all moved",
                          result["planes"].get<int>(), bytes_per_m2, tenth_over_all),
                result});
    report.set("correction_tenth_over_all", tenth_over_all);
    report.set("bytes_per_m2_at_most_ribbons", bytes_per_m2);
  }
  report.set("correction_growth_exponent", fitted_exponent(x, y));
}

nlohmann::json office_run(const Inputs& inputs, const Recording& tour) {
  Modeler modeler(inputs.config);
  const LineTimes times = feed(tour, modeler);
  std::vector<Plane> planes;
  nlohmann::json result;
  result["line_s"] = median(times.modelled);
  result["seconds"] = correction_s(modeler, true_trajectory(tour), planes);
  result["bytes"] = modeler.memory_bytes();
  result["ribbons"] = modeler.statistics().ribbons;
  result["area_m2"] = total_area_m2(planes);
  result["metrics"] = to_json(eval::compare_maps(eval::patches_of(planes), tour.truth));
  return result;
}

/// A floor of offices, driven through in the simulator.
void offices(const Inputs& inputs, Report& report) {
  std::vector<double> rooms_x, line_y, correction_y;
  const auto numbers = inputs.options.quick ? std::vector<int>{4} : std::vector<int>{4, 12, 36};
  for (const int rooms : numbers) {
    const Recording tour =
        recording_of(office_tour(rooms, inputs.options.output), inputs.options.output);
    const auto run = run_in_child([&] { return office_run(inputs, tour); }, inputs.options.limit_s);
    if (!run) throw std::runtime_error("an office took longer than the limit of CPU time");
    const nlohmann::json& result = run->value;
    rooms_x.push_back(rooms);
    line_y.push_back(result["line_s"]);
    correction_y.push_back(result["seconds"]);
    report.add({"growth: a floor of offices",
                formatted("%d rooms: correction and planes", rooms),
                correction_y.back(),
                {},
                {},
                run->peak_mb,
                formatted("line %.0f us, %d ribbons, %.0f bytes per m2; ", 1e6 * line_y.back(),
                          result["ribbons"].get<int>(),
                          result["bytes"].get<double>() / result["area_m2"].get<double>()) +
                    text_of(result["metrics"]),
                result});
  }
  if (numbers.size() < 2) return;
  report.set("office_line_exponent", fitted_exponent(rooms_x, line_y));
  report.set("office_correction_exponent", fitted_exponent(rooms_x, correction_y));
}

}  // namespace

void measure_growth(const Inputs& inputs, Report& report) {
  lines_over_planes(inputs, report);
  correction_over_ribbons(inputs, report);
  offices(inputs, report);
}

}  // namespace ribbon_mapper::bench
