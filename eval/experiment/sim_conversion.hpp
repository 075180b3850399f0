// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "eval/metrics/patch.hpp"
#include "modeler/scan/laser_beams.hpp"
#include "sim/tour/tour.hpp"
#include "sim/truth/truth.hpp"

namespace ribbon_mapper::eval {

/// Converts a simulated scan to the modeler's input.
LaserBeams beams_of(const sim::Scan& scan);

/// Returns the poses that tf would give for a scan, including the errors of the localisation.
LinePoses noisy_poses(const sim::Tour& tour, const LaserBeams& beams);

/// Returns the poses that tf would give for a scan of the laser on the base.
LinePoses base_laser_poses(const sim::Tour& tour, const LaserBeams& beams);

/// Returns the true poses at the stamps of a trajectory.
std::vector<StampedPose> true_poses(const sim::Tour& tour, std::vector<StampedPose> trajectory);

/// Converts true planes.
std::vector<Patch> patches_of(const std::vector<sim::TruthPlane>& planes);

}  // namespace ribbon_mapper::eval
