// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Checks whether a bag can be mapped: see `bag_check --help`.

#include <cstdio>
#include <variant>

#include "modeler/program/run_program.hpp"
#include "modeler/ros/bag_check/bag_check.hpp"
#include "modeler/ros/bag_check/bag_check_options.hpp"
#include "modeler/ros/bag_check/time_offset.hpp"

int main(int argc, char** argv) {
  using namespace ribbon_mapper;
  return run_program("bag_check", [&] {
    const auto parsed = parse_bag_check_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&parsed)) return *exit_code;
    const auto& options = std::get<BagCheckOptions>(parsed);
    ros::Time::init();
    BagReport report = check_bags(options.bags, options.bag);
    if (report.can_be_mapped() && !options.config.empty()) {
      report_time_offset(options.bags, options.bag, options.config, report);
    }
    std::fputs(report.text().c_str(), stdout);
    return report.can_be_mapped() ? 0 : 1;
  });
}
