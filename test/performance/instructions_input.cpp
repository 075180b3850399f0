// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fixed input for instruction_budget.py: the first lines of the tour, a correction, the planes.
// Prints the result, so that doing less work does not pass as being faster.

#include <cstdio>
#include <exception>

#include "eval/experiment/sim_conversion.hpp"
#include "modeler/modeler.hpp"
#include "modeler/program/installed_files.hpp"

namespace {

using namespace ribbon_mapper;

constexpr std::size_t kLines = 360;  // three periods of the tilt

void run() {
  const auto world = sim::World::load(find_installed_file("worlds/apartment.sdf").string());
  const auto route = sim::Route::load(find_installed_file("worlds/apartment.route.yaml").string());
  sim::Tour tour(world, route, sim::TourConfig());
  Modeler modeler(ModelerConfig{});
  for (std::size_t i = 0; i < kLines; ++i) {
    const LaserBeams beams = eval::beams_of(*tour.next_scan());
    modeler.add_scan_line(beams, eval::noisy_poses(tour, beams));
  }
  std::vector<StampedPose> truth = modeler.trajectory();
  for (StampedPose& pose : truth) pose.T_map_base = tour.true_T_map_base(pose.stamp);
  modeler.correct(truth);
  std::printf("ribbons %zu planes %zu\n", modeler.statistics().ribbons, modeler.planes().size());
}

}  // namespace

int main() {
  try {
    run();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "instructions_input: %s\n", error.what());
    return 1;
  }
}
