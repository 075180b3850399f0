// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "sim/tour/tour.hpp"

namespace ribbon_mapper::sim {

/// Settings of record_tour().
struct RecorderOptions {
  double longest_s = 1e9;  ///< recording ends here, if the tour is longer
  double stamp_error_s =
      0.0;                  ///< constant error of the tilting laser's driver, added to its stamps
  bool base_laser = false;  ///< also records base_scan; casts 3.7 times as many rays
};

/// Records a tour as the robot would and returns the true pose of the base at each line. Writes /tf
/// (map at 30 Hz, odometry and tilt at 100 Hz), /tf_static, tilt_scan and base_scan. The tour
/// starts at kTourStart. The same tour gives the same messages. Needs no master. Throws
/// std::runtime_error if the file cannot be written. `on_line` is called after each line with
/// the number of lines so far.
std::vector<StampedPose> record_tour(Tour& tour, const RecorderOptions& options,
                                     const std::filesystem::path& bag,
                                     const std::function<void(std::size_t)>& on_line = {});

/// Stamp of the start of a recorded tour.
constexpr Time kTourStart = std::chrono::seconds(1000);

/// Returns the first pose of a trajectory, one after each `step_m` of travel, and the last.
std::vector<StampedPose> keyframes(const std::vector<StampedPose>& trajectory, double step_m);

}  // namespace ribbon_mapper::sim
