// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "bench/recording/recording.hpp"
#include "modeler/ros/bag/bag_lines.hpp"

namespace ribbon_mapper::bench {

/// Reads the lines of a bag that have poses in tf, as the node would. There is no ground truth, so
/// recorded poses count as true. Throws std::runtime_error that names the bag if it cannot be read
/// or if fewer than 100 lines have poses.
Recording recording_of_bag(const std::filesystem::path& file, const BagOptions& options);

}  // namespace ribbon_mapper::bench
