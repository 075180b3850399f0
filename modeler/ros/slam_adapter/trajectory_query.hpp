// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/serialization.h>

#include <cstdint>
#include <string>
#include <vector>

namespace ribbon_mapper {

/// The request of cartographer_ros_msgs/TrajectoryQuery, whose package is not in Debian.
struct TrajectoryQueryRequest {
  std::int32_t trajectory_id = 0;  ///< as cartographer numbers them
};

/// The response of cartographer_ros_msgs/TrajectoryQuery.
struct TrajectoryQueryResponse {
  std::uint8_t status_code = 0;                        ///< code of gRPC; 0: success
  std::string status_message;                          ///< the reason of a failure
  std::vector<geometry_msgs::PoseStamped> trajectory;  ///< optimised poses
};

/// The md5 sum that a service accepts for any definition.
constexpr const char* kAnyDefinition = "*";

}  // namespace ribbon_mapper

namespace ros::serialization {

/// Serialises the request.
template <>
struct Serializer<ribbon_mapper::TrajectoryQueryRequest> {
  /// Visits all fields in order.
  template <typename Stream, typename T>
  static void allInOne(Stream& stream, T message) {
    stream.next(message.trajectory_id);
  }
  ROS_DECLARE_ALLINONE_SERIALIZER
};

/// Serialises the response.
template <>
struct Serializer<ribbon_mapper::TrajectoryQueryResponse> {
  /// Visits all fields in order.
  template <typename Stream, typename T>
  static void allInOne(Stream& stream, T message) {
    stream.next(message.status_code);
    stream.next(message.status_message);
    stream.next(message.trajectory);
  }
  ROS_DECLARE_ALLINONE_SERIALIZER
};

}  // namespace ros::serialization
