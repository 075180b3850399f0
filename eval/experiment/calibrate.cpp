// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment/calibrate.hpp"

#include "eval/experiment/run.hpp"
#include "eval/experiment/sim_conversion.hpp"

namespace ribbon_mapper::eval {

Calibration make_calibration(const RunOptions& run, const ProgressCallback& progress) {
  const sim::World world = load_world(run);
  sim::Tour tour(world, load_route(run), tour_config(run));
  Calibrator calibrator(modeler_config(run));
  std::size_t lines = 0;
  while (const std::optional<sim::Scan> scan = tour.next_scan()) {
    const LaserBeams beams = beams_of(*scan);
    calibrator.add(beams, noisy_poses(tour, beams));
    progress({++lines, tour.line_count(), 0, to_seconds(beams.stamp), 0.0});
  }
  return calibrator.result();
}

}  // namespace ribbon_mapper::eval
