// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the paper's experiment without ROS; see `experiment --help`.

#include <cstdio>
#include <fstream>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "eval/experiment/calibrate.hpp"
#include "eval/experiment/experiment_options.hpp"
#include "eval/experiment/run.hpp"
#include "eval/experiment/series.hpp"
#include "eval/results/run_log.hpp"
#include "eval/results/series_summary.hpp"
#include "modeler/io/calibrated_preset.hpp"
#include "modeler/program/figure.hpp"
#include "modeler/program/installed_files.hpp"
#include "modeler/program/interrupt.hpp"
#include "modeler/program/progress_bar.hpp"
#include "modeler/program/run_program.hpp"
#include "modeler/storage/atomic_file.hpp"
#include "modeler/storage/disk.hpp"

namespace {

using namespace ribbon_mapper;
using namespace ribbon_mapper::eval;

/// Says on stderr what each world of these runs holds, once.
void show_worlds(const std::vector<RunOptions>& runs) {
  std::set<std::pair<std::string, std::string>> shown;
  for (const RunOptions& run : runs)
    if (shown.emplace(run.world, run.route).second)
      std::fprintf(stderr, "%s", world_text(run).c_str());
}

/// Returns a callback that shows the progress, and stops the run if the program is asked to end.
ProgressCallback shown_by(ProgressBar& bar) {
  return [&bar](const Progress& progress) {
    stop_if_interrupted();
    bar.show(progress);
  };
}

void run_one(const ExperimentOptions& options) {
  const OutputDirectory directory(options.output);
  show_worlds(options.runs);
  Summary summary;
  {
    ProgressBar bar;
    const Results results = make_run(options.runs.front(), shown_by(bar));
    summary = results.summary;
    FileSet files = staged_results(results, options.output, options.mesh_formats);
    if (options.with_figure) draw_figure(Figure::before_after, files.folder(), options.output);
    if (options.with_floor_plan) draw_floor_plan(files.folder(), options.output);
    files.commit();
  }
  std::printf("%s\nresults in %s\n", summary_table(summary).c_str(), options.output.c_str());
}

/// Prints lines of runs.jsonl, for gathering runs from machines without a shared disk.
void print_lines(const ExperimentOptions& options) {
  show_worlds(options.runs);
  ProgressBar bar;
  const auto line_of = [](const RunOptions& run, const ProgressCallback& progress) {
    return run_line(make_run(run, progress).summary, inputs_of(run));
  };
  make_runs(options.runs, options.jobs, line_of, bar);
}

std::vector<RunOptions> missing_runs(const ExperimentOptions& options, const RunLog& log) {
  std::vector<RunOptions> missing;
  for (const RunOptions& run : options.runs) {
    if (!log.has(run, inputs_of(run))) missing.push_back(run);
  }
  return missing;
}

void make_missing_runs(const ExperimentOptions& options, RunLog& log) {
  const std::vector<RunOptions> missing = missing_runs(options, log);
  if (missing.size() < options.runs.size()) {
    std::printf("%zu of %zu runs are done already\n", options.runs.size() - missing.size(),
                options.runs.size());
  }
  if (missing.empty()) return;
  show_worlds(missing);
  std::ofstream timings(options.output / "timings.jsonl", std::ios::app);
  std::mutex mutex;
  ProgressBar bar;
  const std::size_t label_width = label_width_of(options.runs);
  bar.print(series_table_head(label_width));
  const auto run_and_log = [&](const RunOptions& run, const ProgressCallback& progress) {
    const Summary summary = make_run(run, progress).summary;
    const std::string line = run_line(summary, inputs_of(run));
    const std::lock_guard<std::mutex> lock(mutex);
    log.append(line);
    timings << timing_line(summary) << std::flush;
    if (!timings) throw std::runtime_error("timings.jsonl cannot be written; is the disk full?");
    return series_table_row(label_of(run, options.runs), parse_run_line(line), label_width);
  };
  try {
    make_runs(missing, options.jobs, run_and_log, bar);
  } catch (const Interrupted&) {
    const std::size_t kept = options.runs.size() - missing_runs(options, log).size();
    throw Interrupted("interrupted, " + std::to_string(kept) + " of " +
                      std::to_string(options.runs.size()) + " runs are kept in " +
                      options.output.string() + "; the same command goes on");
  }
}

void run_series(const ExperimentOptions& options) {
  const OutputDirectory directory(options.output);
  RunLog log(options.output / "runs.jsonl");
  make_missing_runs(options, log);
  log.sort();
  const std::vector<LoggedRun> runs = log.logged_runs(options.runs);
  write_file_atomically(options.output / "summary.json",
                        series_summary_to_json(runs, options.command));
  const bool has_doses = runs.front().run.drift != runs.back().run.drift;
  if (options.with_figure && has_doses) draw_figure(Figure::dose_response, options.output);
  std::printf("%s\nresults in %s\n", series_table_foot(runs, label_width_of(options.runs)).c_str(),
              options.output.c_str());
}

/// Learns the tolerances, writes a preset with them and prints the variances.
void calibrate(const ExperimentOptions& options) {
  const OutputDirectory directory(options.output);
  RunOptions run = options.runs.front();
  if (run.route.empty()) {
    run.route =
        find_installed_file(run.world).replace_extension().string() + "_calibration.route.yaml";
  }
  show_worlds({run});
  std::optional<Calibration> calibration;
  {
    ProgressBar bar;
    calibration = make_calibration(run, shown_by(bar));
  }
  const auto preset = options.output / "calibrated.yaml";
  write_file_atomically(preset,
                        calibrated_preset(modeler_config(run), *calibration, options.command));
  std::printf("%s\npreset in %s\n", calibration_table(*calibration).c_str(), preset.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  watch_interrupts();
  return run_program("experiment", [&] {
    const auto options = parse_experiment_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
    const auto& chosen = std::get<ExperimentOptions>(options);
    if (chosen.calibrate) {
      calibrate(chosen);
    } else if (chosen.line_only) {
      print_lines(chosen);
    } else {
      chosen.is_series ? run_series(chosen) : run_one(chosen);
    }
    return 0;
  });
}
