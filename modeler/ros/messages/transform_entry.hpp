// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <cstddef>
#include <optional>
#include <set>
#include <string>

namespace ribbon_mapper {

/// What became of transforms that were to enter a buffer.
struct TransformCounts {
  std::size_t refused = 0;   ///< unusable, see find_defect(), or older than the buffer reaches back
  std::size_t repeated = 0;  ///< stamped as one before: the first counts
  std::size_t differing = 0;  ///< repeated ones that say something else than the first
  std::string defect;         ///< of the last unusable transform, with its frames

  /// Adds other counts.
  TransformCounts& operator+=(const TransformCounts& other);
};

/// Returns what is wrong with a transform; nothing if it can be used. A quaternion is accepted as
/// tf2 does: the square of its length may differ from 1 by up to 0.01.
std::optional<std::string> find_defect(const geometry_msgs::TransformStamped& transform);

/// Returns a usable transform with frames without leading slashes and a quaternion of unit length.
geometry_msgs::TransformStamped cleaned(const geometry_msgs::TransformStamped& transform);

/// Enters a transform without defect into a buffer. Writes to `counts` what became of it: tf2
/// itself would print a line for each that it refuses.
void enter_transform(const geometry_msgs::TransformStamped& transform, bool is_static,
                     tf2::BufferCore& buffer, TransformCounts& counts);

/// Enters transforms into a buffer, cleaned. Leaves out those whose parent is one of `drop_frames`:
/// with `map`, a recorded localisation does not conflict with one that runs now. Returns what
/// became of them.
TransformCounts enter_transforms(const tf2_msgs::TFMessage& message, bool is_static,
                                 const std::set<std::string>& drop_frames, tf2::BufferCore& buffer);

/// Returns "PARENT -> CHILD" with both names as shown() shows them.
std::string link_text(const geometry_msgs::TransformStamped& transform);

/// Returns the frames in a list separated by spaces or commas, without leading slashes.
std::set<std::string> frames_from(const std::string& list);

}  // namespace ribbon_mapper
