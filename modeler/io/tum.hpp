// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// Poses of base_footprint in map as text, one a line: "stamp tx ty tz qx qy qz qw" (seconds,
/// metres, unit quaternion), as the TUM RGB-D benchmark and most SLAM tools write them. Stamps are
/// exact to the nanosecond.
std::string to_tum(const std::vector<StampedPose>& trajectory);

/// The inverse; empty lines and those that start with '#' are skipped. Throws std::runtime_error
/// that names the line if a number is missing, superfluous or not finite, if the quaternion is
/// further than 1 % from unit length, or if the stamps do not increase. `name` stands for the text
/// in these errors.
std::vector<StampedPose> from_tum(const std::string& text, const std::string& name);

/// Reads a file. Throws std::runtime_error if it cannot be read, and as from_tum() does.
std::vector<StampedPose> read_tum(const std::filesystem::path& path);

}  // namespace ribbon_mapper
