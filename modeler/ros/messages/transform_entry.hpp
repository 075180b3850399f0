// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <set>
#include <string>

namespace ribbon_mapper {

/// Enters transforms into a buffer, leading slashes stripped. Those whose parent is one of
/// `drop_frames` are left out: with `map`, a recorded localisation does not fight one that runs
/// now. Returns how many were not usable: not finite, no unit quaternion, a frame in itself, or too
/// old.
std::size_t enter_transforms(const tf2_msgs::TFMessage& message, bool is_static,
                             const std::set<std::string>& drop_frames, tf2::BufferCore& buffer);

/// Frame names in a text, parted by spaces or commas; leading slashes stripped.
std::set<std::string> frames_from(const std::string& list);

}  // namespace ribbon_mapper
