// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <set>
#include <string>

namespace ribbon_mapper {

/// Enters transforms into a buffer without leading slashes. Leaves out those whose parent is one of
/// `drop_frames`: with `map`, a recorded localisation does not conflict with one that runs now.
/// Returns how many were unusable: not finite, no unit quaternion, child equal to parent, or too
/// old.
std::size_t enter_transforms(const tf2_msgs::TFMessage& message, bool is_static,
                             const std::set<std::string>& drop_frames, tf2::BufferCore& buffer);

/// Returns the frames in a list separated by spaces or commas, without leading slashes.
std::set<std::string> frames_from(const std::string& list);

}  // namespace ribbon_mapper
