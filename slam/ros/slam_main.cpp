// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Estimates the trajectory of a bag without a master: see `offline_slam --help`.

#include <ros/time.h>

#include <chrono>
#include <cstdio>

#include "modeler/program/process_cost.hpp"
#include "modeler/program/progress_bar.hpp"
#include "modeler/program/run_program.hpp"
#include "modeler/storage/disk.hpp"
#include "slam/ros/slam_run.hpp"

namespace {

using namespace ribbon_mapper;
using Clock = std::chrono::steady_clock;

void run(const slam::SlamOptions& options) {
  const Clock::time_point start = Clock::now();
  const OutputDirectory directory(options.output);
  slam::SlamRun result;
  {
    ProgressBar bar;
    result = slam::run_slam(options, [&](const Progress& progress) { bar.show(progress); });
  }
  const ProcessCost cost = process_cost();
  result.summary.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  result.summary.cpu_s = cost.cpu_s;
  result.summary.peak_memory_mib = cost.peak_memory_mib;
  slam::write_slam(result, options.output, options.with_figure);
  std::printf("%sresults in %s\n", summary_text(result.summary).c_str(), options.output.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("offline_slam", [&] {
    const auto options = slam::parse_slam_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
    ros::Time::init();
    run(std::get<slam::SlamOptions>(options));
    return 0;
  });
}
