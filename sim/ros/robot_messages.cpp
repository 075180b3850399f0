// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/ros/robot_messages.hpp"

#include "modeler/ros/messages/message_conversions.hpp"
#include "sim/robot/pr2.hpp"

namespace ribbon_mapper::sim {

sensor_msgs::LaserScan scan_message(const Scan& scan, const std::string& frame,
                                    const ros::Time& stamp) {
  sensor_msgs::LaserScan message;
  message.header.frame_id = frame;
  message.header.stamp = stamp;
  message.angle_min = static_cast<float>(scan.angle_min_rad);
  message.angle_increment = static_cast<float>(scan.angle_increment_rad);
  message.angle_max =
      static_cast<float>(scan.angle_min_rad + (static_cast<double>(scan.ranges_m.size()) - 1.0) *
                                                  scan.angle_increment_rad);
  message.time_increment = static_cast<float>(scan.time_increment_s);
  message.scan_time = static_cast<float>(scan.scan_time_s);
  message.range_min = static_cast<float>(scan.range_min_m);
  message.range_max = static_cast<float>(scan.range_max_m);
  message.ranges = scan.ranges_m;
  return message;
}

sensor_msgs::JointState joint_message(double tilt_rad, const ros::Time& stamp) {
  sensor_msgs::JointState message;
  message.header.stamp = stamp;
  message.name = {"torso_lift_joint", "laser_tilt_mount_joint"};
  message.position = {pr2::kTorsoRest_m, tilt_rad};
  return message;
}

geometry_msgs::TransformStamped stamped_transform(const std::string& parent,
                                                  const std::string& child, const Pose& pose,
                                                  const ros::Time& stamp) {
  geometry_msgs::TransformStamped message;
  message.header.frame_id = parent;
  message.header.stamp = stamp;
  message.child_frame_id = child;
  message.transform = transform_message(pose);
  return message;
}

nav_msgs::Odometry odometry_message(const std::string& parent, const std::string& child,
                                    const Pose& pose, const Velocity& velocity,
                                    const ros::Time& stamp) {
  nav_msgs::Odometry message;
  message.header.frame_id = parent;
  message.header.stamp = stamp;
  message.child_frame_id = child;
  message.pose.pose = pose_message(pose);
  message.twist.twist.linear.x = velocity.forward_m_s;
  message.twist.twist.angular.z = velocity.turn_rad_s;
  return message;
}

}  // namespace ribbon_mapper::sim
