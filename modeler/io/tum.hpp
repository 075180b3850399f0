// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "modeler/chain/matrix6.hpp"
#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// Converts poses of base_footprint in map to the text format of the TUM RGB-D benchmark. Each line
/// is "stamp tx ty tz qx qy qz qw" (seconds, metres, unit quaternion); stamps are exact to the
/// nanosecond. A comment states the id of the `run`, if it is not empty.
std::string to_tum(const std::vector<StampedPose>& trajectory, const std::string& run = "");

/// Name of the file with the covariances of a trajectory, beside it.
constexpr const char* kCovarianceFile = "trajectory_covariance.csv";

/// Converts the covariances of poses, by pose, to a table with a line each: the stamp, then the
/// upper triangle row by row. Rows and columns are those of geometry_msgs/PoseWithCovariance: x, y,
/// z [m], then rotations about the fixed axes x, y, z of map [rad]. The first line is a comment
/// with the id of the `run`, if it is not empty, the next one names the columns. Throws
/// std::invalid_argument if there is not one covariance for each pose.
std::string to_covariance_csv(const std::vector<StampedPose>& trajectory,
                              const std::vector<Matrix6>& covariances, const std::string& run = "");

/// Parses text in TUM format; empty lines and lines that start with '#' are skipped. Throws
/// std::runtime_error with `name` and the line if a number is missing, superfluous or not finite,
/// if the quaternion deviates from unit length by more than 1 %, if a coordinate exceeds
/// kMaxCoordinate_m, or if stamps do not increase.
std::vector<StampedPose> from_tum(const std::string& text, const std::string& name);

/// Reads a file in TUM format. Throws std::runtime_error if it cannot be read, and as from_tum().
std::vector<StampedPose> read_tum(const std::filesystem::path& path);

}  // namespace ribbon_mapper
