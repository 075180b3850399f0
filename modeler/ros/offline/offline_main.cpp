// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Models a bag without a master: see `offline_modeler --help`.

#include <chrono>
#include <cstdio>
#include <string>

#include "modeler/program/interrupt.hpp"
#include "modeler/program/process_cost.hpp"
#include "modeler/program/progress_bar.hpp"
#include "modeler/program/run_program.hpp"
#include "modeler/ros/offline/offline_run.hpp"
#include "modeler/storage/disk.hpp"

namespace {

using namespace ribbon_mapper;
using Clock = std::chrono::steady_clock;

void run(const OfflineOptions& options, const std::string& command) {
  const Clock::time_point start = Clock::now();
  const OutputDirectory directory(options.output);
  OfflineRun run;
  {
    ProgressBar bar;
    run = model_bags(options, [&](const Progress& progress) {
      stop_if_interrupted();
      bar.show(progress);
    });
  }
  const ProcessCost cost = process_cost();
  run.summary.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  run.summary.cpu_s = cost.cpu_s;
  run.summary.peak_memory_mib = cost.peak_memory_mib;
  run.command = command;
  write_model(run, options.output,
              {options.with_figure, options.with_floor_plan, options.mesh_formats});
  std::printf("%sresults in %s\n", summary_text(run.summary).c_str(), options.output.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  watch_interrupts();
  return run_program("offline_modeler", [&] {
    const auto options = parse_offline_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
    ros::Time::init();
    std::string command = "rosrun ribbon_mapper offline_modeler";
    for (int i = 1; i < argc; ++i) command += std::string(" ") + argv[i];
    run(std::get<OfflineOptions>(options), command);
    return 0;
  });
}
