// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/modeler_config.hpp"
#include "modeler/ribbon/ribbon.hpp"
#include "modeler/trajectory/trajectory.hpp"

namespace ribbon_mapper {

/// Poses of all lines of a corrected trajectory, of which those between corrected poses are where
/// the model itself tells.
///
/// Between two corrected poses the odometry's error is a random walk that is zero at both. Where it
/// may have moved ribbons off their planes, the lines are registered against the planes of those
/// lines that are known to be placed right (at first: those next to corrected poses), by a bridge
/// between the two corrected poses; then the planes are evaluated again with the lines that are now
/// placed right, and so on. Corrected poses are never touched. How large the odometry's error is,
/// its mismatch from each corrected pose to the next one shows.
///
/// The lines before the first and after the last corrected pose are registered from that one end,
/// unless there are more than the longest bridge has.
///
/// A bridge is registered if it has more than three lines (a ribbon is made of three) and if by the
/// odometry's error ribbons may lie further off (one sigma) than what a ribbon itself can tell, see
/// shared_part_of_sigma. The result is empty if there is none: corrected poses are nearly as dense
/// as the lines, there is but one, or the odometry is good enough to be believed between them.
/// `ribbons`: in the order of their lines.
std::vector<StampedPose> registered_poses(const std::vector<Ribbon>& ribbons,
                                          const Trajectory& trajectory, const ModelerConfig& config,
                                          double range_sigma_m);

}  // namespace ribbon_mapper
