// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/serialization.h>

#include <cstdint>
#include <string>
#include <vector>

// cartographer_ros_msgs/TrajectoryQuery as it goes over the wire. The package is not in Debian.
namespace ribbon_mapper {

struct TrajectoryQueryRequest {
  std::int32_t trajectory_id = 0;
};

struct TrajectoryQueryResponse {
  std::uint8_t status_code = 0;  ///< of grpc, 0: all right
  std::string status_message;
  std::vector<geometry_msgs::PoseStamped> trajectory;
};

/// A service accepts this in place of the md5 sum of its definition.
constexpr const char* kAnyDefinition = "*";

}  // namespace ribbon_mapper

namespace ros::serialization {

template <>
struct Serializer<ribbon_mapper::TrajectoryQueryRequest> {
  template <typename Stream, typename T>
  static void allInOne(Stream& stream, T message) {
    stream.next(message.trajectory_id);
  }
  ROS_DECLARE_ALLINONE_SERIALIZER
};

template <>
struct Serializer<ribbon_mapper::TrajectoryQueryResponse> {
  template <typename Stream, typename T>
  static void allInOne(Stream& stream, T message) {
    stream.next(message.status_code);
    stream.next(message.status_message);
    stream.next(message.trajectory);
  }
  ROS_DECLARE_ALLINONE_SERIALIZER
};

}  // namespace ros::serialization
