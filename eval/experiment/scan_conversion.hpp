// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/scan/laser_beams.hpp"
#include "sim/tour/tour.hpp"

namespace ribbon_mapper::eval {

// What a modeler is told of a simulated tour.

LaserBeams beams_of(const sim::Scan& scan);

/// What tf says on the robot: poses with the errors of its localisation.
LinePoses noisy_poses(const sim::Tour& tour, const LaserBeams& beams);

}  // namespace ribbon_mapper::eval
