// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/serialization.h>
#include <rosbag/message_instance.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

namespace ribbon_mapper {

/// Returns whether a message has room for as many elements as it says. ROS makes room for them
/// before it looks: four wrong bytes cost gigabytes.
inline bool has_room(const std::vector<std::uint8_t>& bytes, const sensor_msgs::LaserScan*) {
  const auto count_at = [&](std::size_t at) {
    std::uint32_t count = 0xffffffffu;
    if (at + 4 <= bytes.size()) std::memcpy(&count, bytes.data() + at, 4);
    return static_cast<std::size_t>(count);
  };
  constexpr std::size_t kName = 12, kNumbers = 28;  // seq and stamp; angles, times, range limits
  const std::size_t ranges = kName + 4 + count_at(kName) + kNumbers;
  const std::size_t intensities = ranges + 4 + 4 * count_at(ranges);
  return intensities + 4 + 4 * count_at(intensities) <= bytes.size();
}
/// The same for transforms.
inline bool has_room(const std::vector<std::uint8_t>& bytes, const tf2_msgs::TFMessage*) {
  constexpr std::size_t kSmallest = 76;  // a transform with empty names
  std::uint32_t count = 0;
  if (bytes.size() < 4) return false;
  std::memcpy(&count, bytes.data(), 4);
  return count <= bytes.size() / kSmallest;
}

/// Odometry has no lists: nothing is made room for.
inline bool has_room(const std::vector<std::uint8_t>&, const nav_msgs::Odometry*) { return true; }

/// Returns a message; nothing if it is of another type. Throws ros::Exception if it is damaged.
template <typename Message>
std::optional<Message> message_of(const rosbag::MessageInstance& instance) {
  if (instance.getMD5Sum() != ros::message_traits::md5sum<Message>()) return std::nullopt;
  std::vector<std::uint8_t> bytes(instance.size());
  ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  instance.write(out);
  if (!has_room(bytes, static_cast<const Message*>(nullptr)))
    throw ros::Exception("a message is shorter than it says");
  ros::serialization::IStream in(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  std::optional<Message> message(std::in_place);
  ros::serialization::deserialize(in, *message);
  return message;
}

}  // namespace ribbon_mapper
