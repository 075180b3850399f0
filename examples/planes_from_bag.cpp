// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
/// Models a ROS bag without a ROS master: planes_from_bag BAG PRESET [CORRECTED_TRAJECTORY.tum]
#include <ros/time.h>

#include <cstdio>
#include <exception>

#include "modeler/io/config_file.hpp"
#include "modeler/io/tum.hpp"
#include "modeler/modeler.hpp"
#include "modeler/ros/bag/bag_lines.hpp"

using namespace ribbon_mapper;

namespace {

/// Returns the model of all lines in a bag, and reports lines without a pose.
Modeler model_of_bag(const char* bag, const ModelerConfig& config) {
  Modeler modeler(config);
  LineLog log;
  BagLines lines({bag}, BagOptions{}, log);
  while (const std::optional<ReadyLine> line = lines.next()) {
    modeler.add_scan_line(line->beams, line->poses);
  }
  for (const auto& [reason, count] : log.dropped_by_reason()) {
    std::printf("%zu lines dropped: %s\n", count, reason.c_str());
  }
  return modeler;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 || argc > 4) {
    std::fprintf(stderr, "usage: planes_from_bag BAG PRESET [CORRECTED_TRAJECTORY.tum]\n");
    return 2;
  }
  ros::Time::init();
  try {
    Modeler modeler = model_of_bag(argv[1], load_config(argv[2]));
    if (argc == 4) modeler.correct(read_tum(argv[3]));
    const std::vector<Plane> planes = modeler.planes();
    for (const Plane& plane : planes) std::printf("plane of %.2f m2\n", plane.area_m2);
    return planes.empty() ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
