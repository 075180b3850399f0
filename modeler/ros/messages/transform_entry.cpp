// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/messages/transform_entry.hpp"

#include <tf2/exceptions.h>

#include <cmath>

#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

/// Returns whether tf2 can use a transform. It would print a message for each that it refuses.
bool is_usable(const geometry_msgs::TransformStamped& transform) {
  const geometry_msgs::Vector3& t = transform.transform.translation;
  const geometry_msgs::Quaternion& q = transform.transform.rotation;
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  const std::string parent = without_slash(transform.header.frame_id);
  const std::string child = without_slash(transform.child_frame_id);
  return std::abs(length - 1.0) < 1e-3 && std::isfinite(t.x + t.y + t.z) && !parent.empty() &&
         !child.empty() && parent != child;
}

}  // namespace

std::size_t enter_transforms(const tf2_msgs::TFMessage& message, bool is_static,
                             const std::set<std::string>& drop_frames, tf2::BufferCore& buffer) {
  std::size_t refused = 0;
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    if (drop_frames.count(without_slash(transform.header.frame_id)) != 0) continue;
    try {
      if (!is_usable(transform) || !buffer.setTransform(transform, "tf", is_static)) ++refused;
    } catch (const tf2::TransformException&) {
      ++refused;
    }
  }
  return refused;
}

std::set<std::string> frames_from(const std::string& list) {
  std::set<std::string> frames;
  for (std::size_t begin = 0; begin < list.size();) {
    begin = list.find_first_not_of(" ,", begin);
    if (begin == std::string::npos) break;
    const std::size_t end = std::min(list.find_first_of(" ,", begin), list.size());
    frames.insert(without_slash(list.substr(begin, end - begin)));
    begin = end;
  }
  return frames;
}

}  // namespace ribbon_mapper
