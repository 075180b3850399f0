// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/registration/plane_observation.hpp"
#include "modeler/registration/pose_belief.hpp"

namespace ribbon_mapper {

/// A ribbon on the plane that it was seen on.
struct PlaneSighting {
  const Sight* sight = nullptr;
  std::uint32_t plane = 0;
};

/// A line whose pose is known, and what it sees.
struct FixedLine {
  Pose T_model_base = Pose::Identity();
  std::vector<PlaneSighting> sightings;
};

/// Successive lines whose poses are not known, chained by odometry to each other and to the known
/// poses at the ends (at least one).
struct LineChain {
  std::optional<Pose> first_end, last_end;
  std::vector<Pose> steps;         ///< first end to first line, .., last line to last end
  std::vector<Vector6> variances;  ///< of the steps, in the frame of the base
  std::vector<FixedLine> lines;    ///< poses as they are believed to be so far
};

/// Planes and the poses of the lines that see them, together: one step of Gauss and Newton on
/// distances and tilts of all ribbons and on all steps of the odometry. (In turn, planes and poses
/// would hardly move: each line keeps to the planes, and these to their lines.) The poses are
/// eliminated chain by chain, what remains is a dense system of three numbers a plane.
void adjust(const std::vector<FixedLine>& fixed, std::vector<LineChain>& chains,
            std::vector<SightedPlane>& planes);

}  // namespace ribbon_mapper
