// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
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

constexpr double kSpacing_m = 40.0;  // more than the range of a ribbon
constexpr std::size_t kToursOfAMillion = 34;
constexpr std::size_t kMaxTours = 100;  // about three million ribbons
constexpr double kRevised_s = 12.0;     // at the end of the trajectory
constexpr double kLimit_s = 1800.0;     // CPU time of our own work; --limit is for the peers

template <typename... Values>
std::string formatted(const char* format, Values... values) {
  char text[240];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

double total_area_m2(const std::vector<Plane>& planes) {
  double sum = 0.0;
  for (const Plane& plane : planes) sum += plane.area_m2;
  return sum;
}

/// Removes the limit of ribbons, as growth is measured on models without thinning.
ModelerConfig without_limit(ModelerConfig config) {
  config.observations.max_ribbons = 0;
  return config;
}

/// Returns whether there is enough memory. Adds a row that says so if there is not.
bool has_room(double needed_mb, const std::string& section, const std::string& name,
              Report& report) {
  if (needed_mb < available_mb()) return true;
  const std::string text = formatted("left out: needs about %.1f GB of memory", 1e-3 * needed_mb);
  report.add({section, name, {}, {}, {}, {}, text, {}});
  return false;
}

/// Measures lines while two periods of the tilt in the apartment are repeated at more and more
/// places.
void lines_over_planes(const Inputs& inputs, Report& report) {
  const std::string section = "growth: time of a line over planes";
  Recording piece = inputs.recording;
  const auto middle = piece.lines.begin() + static_cast<std::ptrdiff_t>(piece.lines.size() / 2);
  piece.lines = std::vector<RecordedLine>(middle, middle + 240);
  const Tiles tiles(piece, kSpacing_m, 60);
  const double before_mb = resident_mb();
  Modeler modeler(without_limit(inputs.config));
  constexpr std::size_t kMeasured = 5;  // number of tiles around each number
  const std::vector<std::size_t> numbers =
      inputs.options.quick ? std::vector<std::size_t>{3, 30, 100}
                           : std::vector<std::size_t>{3, 10, 30, 100, 300, 1000, 3500};
  std::vector<double> x, y;
  std::size_t fed = 0, planes_of_place = 0;
  for (const std::size_t number : numbers) {
    const std::string name = formatted("%zu places", number);
    const double grown_mb = resident_mb() - before_mb;
    if (fed > 0 && !has_room(grown_mb * number / fed - grown_mb, section, name, report)) break;
    std::vector<double> seconds;
    for (; fed < number + kMeasured / 2; ++fed) {
      const double mean_s = tiles.feed(fed, modeler);
      if (fed + 1 + kMeasured / 2 >= number) seconds.push_back(mean_s);
    }
    x.push_back(static_cast<double>(number));
    y.push_back(median(seconds));
    if (planes_of_place == 0) planes_of_place = modeler.planes_as_built().size() / fed;
    const std::size_t ribbons = modeler.statistics().ribbons;
    report.add(
        {section,
         name,
         y.back(),
         {},
         y.back() / y.front(),
         {},
         formatted("about %zu planes as built, %zu ribbons", number * planes_of_place, ribbons),
         {{"places", number}, {"ribbons", ribbons}}});
  }
  report.set("line_growth_exponent", fitted_exponent(x, y));
}

/// Corrects the model, evaluates its planes and returns the CPU time [s].
double correction_s(Modeler& modeler, const std::vector<StampedPose>& trajectory,
                    std::vector<Plane>& planes) {
  return cpu_seconds_of([&] {
    modeler.correct(trajectory);
    planes = modeler.planes();
  });
}

/// Returns statistics of F1 over the places.
nlohmann::json f1_of(const std::vector<eval::MapMetrics>& places) {
  std::vector<double> f1;
  for (const eval::MapMetrics& place : places) f1.push_back(place.f1);
  return {{"first", f1.front()},
          {"last", f1.back()},
          {"median", median(f1)},
          {"worst", *std::min_element(f1.begin(), f1.end())},
          {"all", f1}};
}

/// Models the whole tour at `number` places, then measures corrections.
nlohmann::json corrections_of(const Recording& tour, const ModelerConfig& config,
                              std::size_t number) {
  const Tiles tiles(tour, kSpacing_m, 10);
  Modeler modeler(config);
  nlohmann::json result;
  double line_s = 0.0;
  for (std::size_t k = 0; k < number; ++k) line_s += tiles.feed(k, modeler);
  const auto truth = tiles.truth(number);
  const auto tenth = bent(truth, 0.1), all = bent(truth, 1.0);
  std::vector<Plane> planes;
  result["line_s"] = line_s / static_cast<double>(number);
  const double correct_s = cpu_seconds_of([&] { modeler.correct(truth); });
  const double planes_s = cpu_seconds_of([&] { planes = modeler.planes(); });
  result["correct_s"] = correct_s, result["planes_s"] = planes_s;
  result["seconds"] = correct_s + planes_s;
  result["planes"] = planes.size();
  result["f1"] = f1_of(tiles.judged(planes, number));
  result["area_m2"] = total_area_m2(planes);
  result["bytes"] = modeler.memory_bytes();
  result["ribbons"] = modeler.statistics().ribbons;
  result["thinned"] = modeler.statistics().thinned;
  result["lines"] = modeler.trajectory().size();
  result["tenth_s"] = correction_s(modeler, tenth, planes);
  result["all_s"] = correction_s(modeler, all, planes);
  const auto revised = bent(all, kRevised_s / (static_cast<double>(number) * tour.duration_s));
  result["revision_s"] = cpu_seconds_of([&] { modeler.correct(revised); });
  return result;
}

/// Runs corrections_of() in a child process.
ChildResult corrections_in_child(const Recording& tour, const ModelerConfig& config,
                                 std::size_t number) {
  const auto run = run_in_child([&] { return corrections_of(tour, config, number); }, kLimit_s);
  if (!run) throw std::runtime_error("the corrections took longer than half an hour of CPU time");
  return *run;
}

/// Measures corrections of the whole tour at more and more places, up to three million ribbons.
void correction_over_ribbons(const Inputs& inputs, Report& report) {
  const std::string section = "growth: correction and planes over ribbons";
  const std::vector<std::size_t> numbers =
      inputs.options.quick ? std::vector<std::size_t>{1, 3}
                           : std::vector<std::size_t>{1, 3, 10, kToursOfAMillion, kMaxTours};
  std::vector<double> x, y, revision_s;
  double tour_mb = 0.0;
  for (const std::size_t number : numbers) {
    const double needed_mb = tour_mb * static_cast<double>(number);
    if (!has_room(needed_mb, section, formatted("%zu tours", number), report)) break;
    const ChildResult run =
        corrections_in_child(inputs.recording, without_limit(inputs.config), number);
    const nlohmann::json& result = run.value;
    tour_mb = run.peak_mb / static_cast<double>(number);
    x.push_back(result["ribbons"]);
    y.push_back(result["seconds"]);
    revision_s.push_back(result["revision_s"]);
    const double tenth_over_all = result["tenth_s"].get<double>() / result["all_s"].get<double>();
    const double bytes_per_m2 = result["bytes"].get<double>() / result["area_m2"].get<double>();
    report.add({section,
                formatted("%.0f ribbons", x.back()),
                y.back(),
                1e9 * y.back() / x.back(),
                {},
                run.peak_mb,
                formatted("%d planes, worst place F1 %.3f, %.0f bytes per m2; a tenth moved: %.2f "
                          "of all moved",
                          result["planes"].get<int>(), result["f1"]["worst"].get<double>(),
                          bytes_per_m2, tenth_over_all),
                result});
    report.set("correction_tenth_over_all", tenth_over_all);
    report.set("revision_growth_exponent", x.size() > 1 ? fitted_exponent(x, revision_s) : 1.0);
    report.set("bytes_per_m2_at_most_ribbons", bytes_per_m2);
    const bool is_up_to_a_million = number <= kToursOfAMillion;
    report.set(is_up_to_a_million ? "correction_growth_exponent"
                                  : "correction_growth_exponent_to_three_million",
               x.size() > 1 ? fitted_exponent(x, y) : 1.0);
  }
}

/// Measures a model that has observed far more than `observations.max_ribbons`.
void model_at_its_limit(const Inputs& inputs, Report& report) {
  if (inputs.options.quick || inputs.config.observations.max_ribbons == 0) return;
  const ChildResult run = corrections_in_child(inputs.recording, inputs.config, kMaxTours);
  const nlohmann::json& result = run.value;
  const std::size_t kept = result["ribbons"], left_out = result["thinned"];
  const double megabytes = 1e-6 * result["bytes"].get<double>();
  const nlohmann::json& f1 = result["f1"];
  report.add(
      {formatted("growth: a model of %d ribbons at most", inputs.config.observations.max_ribbons),
       formatted("%zu ribbons seen: correction and planes", kept + left_out),
       result["seconds"].get<double>(),
       1e9 * result["seconds"].get<double>() / static_cast<double>(kept),
       {},
       run.peak_mb,
       formatted("%zu kept of %d lines, %.0f MB; %d planes, F1 first place %.3f, last %.3f, median "
                 "%.3f, worst %.3f; mean time of a line %.0f us with thinning",
                 kept, result["lines"].get<int>(), megabytes, result["planes"].get<int>(),
                 f1["first"].get<double>(), f1["last"].get<double>(), f1["median"].get<double>(),
                 f1["worst"].get<double>(), 1e6 * result["line_s"].get<double>()),
       result});
  report.set("limited_ribbons", static_cast<double>(kept));
  report.set("limited_mb", megabytes);
  report.set("limited_f1_last_place", f1["last"]);
  report.set("limited_f1_median_place", f1["median"]);
}

nlohmann::json office_run(const Inputs& inputs, const Recording& tour) {
  Modeler modeler(inputs.config);
  const LineTimes times = feed(tour, modeler);
  std::vector<Plane> planes;
  nlohmann::json result;
  result["line_s"] = median(times.modelled());
  result["seconds"] = correction_s(modeler, true_trajectory(tour), planes);
  result["bytes"] = modeler.memory_bytes();
  result["ribbons"] = modeler.statistics().ribbons;
  result["area_m2"] = total_area_m2(planes);
  result["metrics"] = to_json(eval::compare_maps(eval::patches_of(planes), tour.truth));
  return result;
}

/// Measures simulated tours through office floors.
void offices(const Inputs& inputs, Report& report) {
  std::vector<double> rooms_x, line_y, correction_y;
  const auto numbers = inputs.options.quick ? std::vector<int>{4} : std::vector<int>{4, 12, 36};
  for (const int rooms : numbers) {
    const Recording tour =
        recording_of(office_tour(rooms, inputs.options.output), inputs.options.output);
    const auto run = run_in_child([&] { return office_run(inputs, tour); }, kLimit_s);
    if (!run) throw std::runtime_error("an office took longer than half an hour of CPU time");
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
  model_at_its_limit(inputs, report);
  offices(inputs, report);
}

}  // namespace ribbon_mapper::bench
