// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/registration/registration_config.hpp"
#include "modeler/ribbon/ribbon.hpp"
#include "modeler/trajectory/trajectory.hpp"

namespace ribbon_mapper {

/// Refines the poses of lines between corrected poses by registering their ribbons to the model's
/// planes. Returns one pose per line, or nothing if there is nothing to register.
///
/// Between two corrected poses the odometry's error is a random walk that is zero at both; its
/// scale is fitted to the mismatch from each corrected pose to the next. Corrected poses are never
/// changed. Each round builds landmarks from the lines whose poses are known well enough, at first
/// those next to corrected poses. Then it smooths each segment with what its lines measure of the
/// landmarks, and adjusts landmarks and poses together.
///
/// A segment is registered if it has more than three lines (a ribbon takes three) and if odometry
/// may displace some ribbon by more than the error that ranges share, shared_sigma_ratio. An open
/// segment, before the first or after the last corrected pose, is registered from its one end
/// unless it is longer than the longest of the others.
///
/// There is nothing to register if the registration is disabled, the trajectory was never
/// corrected, corrected poses are nearly as dense as lines, there is only one, or odometry suffices
/// between them. `ribbons` are in the order of their lines.
std::vector<StampedPose> registered_poses(const std::vector<Ribbon>& ribbons,
                                          const Trajectory& trajectory,
                                          const RegistrationConfig& config,
                                          const SharedSettings& shared);

}  // namespace ribbon_mapper
