// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Models a bag without a master: see `offline_modeler --help`.

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <exception>

#include "modeler/io/atomic_file.hpp"
#include "modeler/program/figure.hpp"
#include "modeler/program/progress_bar.hpp"
#include "modeler/ros/offline/offline_run.hpp"

namespace {

using namespace ribbon_mapper;
using Clock = std::chrono::steady_clock;

double seconds(const timeval& time) { return time.tv_sec + 1e-6 * time.tv_usec; }

/// Adds the time and memory that the process has used so far.
void add_cost(Clock::time_point start, OfflineSummary& summary) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  summary.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  summary.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  summary.peak_memory_mib = usage.ru_maxrss / 1024.0;
}

void run(const OfflineOptions& options) {
  const Clock::time_point start = Clock::now();
  create_directory_for_files(options.output);  // better now than after the work
  OfflineRun run;
  {
    ProgressBar bar;
    run = model_bags(options, [&](const Progress& progress) { bar.show(progress); });
  }
  write_model(run, options.output);
  add_cost(start, run.summary);
  write_file_atomically(options.output / "summary.json", summary_to_json(run.summary));
  if (options.with_figure && !run.planes_after.empty()) {
    draw_figure(Figure::model_views, options.output);
  }
  std::printf("%sresults in %s\n", summary_text(run.summary).c_str(), options.output.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const auto options = parse_offline_options(argc, argv);
  if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
  try {
    ros::Time::init();
    run(std::get<OfflineOptions>(options));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "offline_modeler: %s\n", error.what());
    return 1;
  }
}
