// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "sim/tour/tour.hpp"

namespace ribbon_mapper::sim {

struct RecorderOptions {
  double longest_s = 1e9;      ///< of the tour that is recorded
  double stamp_error_s = 0.0;  ///< that the laser's driver makes: added to the scans' stamps
};

/// Records a tour as the robot would: /tf (map at 30 Hz, odometry and tilt at 100 Hz), /tf_static,
/// tilt_scan; no master is needed. The tour starts at kTourStart. The same tour gives the same
/// messages. Throws std::runtime_error if the file cannot be written. Returns the true pose of the
/// base at each line.
std::vector<StampedPose> record_tour(Tour& tour, const RecorderOptions& options,
                                     const std::filesystem::path& bag);

constexpr Time kTourStart = std::chrono::seconds(1000);

/// Of a trajectory, the first pose, one after each `step_m` of way, and the last.
std::vector<StampedPose> keyframes(const std::vector<StampedPose>& trajectory, double step_m);

}  // namespace ribbon_mapper::sim
