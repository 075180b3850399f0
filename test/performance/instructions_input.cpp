// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fixed input whose instructions guard.py counts: the first lines of the tour, a correction,
// the planes. Prints what came of it, so that less work cannot pass for faster work.

#include <cstdio>
#include <exception>

#include "modeler/modeler.hpp"
#include "modeler/program/installed_files.hpp"
#include "sim/tour/tour.hpp"

namespace {

using namespace ribbon_mapper;

constexpr std::size_t kLines = 360;  // three periods of the tilt

LinePoses poses_of(const sim::Tour& tour, const LaserBeams& beams) {
  const Time first = beams.stamp, last = end_of(beams);
  return {tour.T_odom_base(first), tour.T_odom_base(last), tour.T_base_laser(first),
          tour.T_base_laser(last), tour.noisy_T_map_base(middle_of(beams))};
}

void run() {
  const auto world = sim::World::load(find_installed_file("worlds/apartment.sdf").string());
  const auto route = sim::Route::load(find_installed_file("worlds/apartment.route.yaml").string());
  sim::Tour tour(world, route, sim::TourConfig());
  Modeler modeler(ModelerConfig{});
  for (std::size_t i = 0; i < kLines; ++i) {
    const sim::Scan scan = *tour.next_scan();
    const LaserBeams beams{scan.stamp,
                           scan.angle_min_rad,
                           scan.angle_increment_rad,
                           scan.time_increment_s,
                           scan.range_min_m,
                           scan.range_max_m,
                           scan.ranges_m};
    modeler.add_scan_line(beams, poses_of(tour, beams));
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
