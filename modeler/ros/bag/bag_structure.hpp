// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace ribbon_mapper {

/// Checks the lengths and places that a bag (version 2.0) gives against its bytes: records, index,
/// chunks, and where messages lie in them. rosbag takes these on trust, and reads beyond its
/// buffers or without an end if they are wrong. Takes about as long as reading the bag. Throws
/// std::runtime_error that says what is wrong. Leaves files of other versions, and those without an
/// index, to rosbag.
void check_bag_structure(const std::filesystem::path& file);

}  // namespace ribbon_mapper
