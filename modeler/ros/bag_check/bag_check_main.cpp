// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Checks whether a bag can be mapped: see `bag_check --help`.

#include <cstdio>
#include <variant>

#include "modeler/io/config_file.hpp"
#include "modeler/program/installed_files.hpp"
#include "modeler/program/progress_bar.hpp"
#include "modeler/program/run_program.hpp"
#include "modeler/ros/bag_check/bag_check.hpp"
#include "modeler/ros/bag_check/bag_check_options.hpp"
#include "modeler/ros/bag_check/preset_proposal.hpp"
#include "modeler/ros/bag_check/time_offset.hpp"
#include "modeler/storage/atomic_file.hpp"

int main(int argc, char** argv) {
  using namespace ribbon_mapper;
  return run_program("bag_check", [&] {
    const auto parsed = parse_bag_check_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&parsed)) return *exit_code;
    const auto& options = std::get<BagCheckOptions>(parsed);
    ros::Time::init();
    const std::string preset = find_installed_file(options.config).string();
    const ModelerConfig config = load_config(preset);
    tell_terminal("reading the scans and transforms");
    BagReport report = check_bags(options.bags, options.bag, config);
    if (report.can_be_mapped()) {
      tell_terminal("comparing both for an offset of their clocks");
      report_time_offset(options.bags, options.bag, preset, report);
    }
    std::fputs(report.text().c_str(), stdout);
    if (!options.proposed_preset.empty()) {
      const std::string text = proposed_preset(options.bags, options.bag, config);
      write_file_atomically(options.proposed_preset, text);
      std::printf("preset written to %s\n", options.proposed_preset.c_str());
    }
    return report.can_be_mapped() ? 0 : 1;
  });
}
