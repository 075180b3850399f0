// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Vector3.h>
#include <nav_msgs/Path.h>
#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "modeler/scan/laser_beams.hpp"

namespace ribbon_mapper {

/// Returns a stamp of ROS as a time.
Time time_of(const ros::Time& stamp);
/// Returns a time as a stamp of ROS.
ros::Time stamp_of(Time time);

/// Returns the name of a frame without its leading slash, which tf2 refuses. Old bags have it.
std::string without_slash(const std::string& frame);

/// The longest name of a frame that is accepted. Longer ones fill logs and memory.
constexpr std::size_t kMaxFrameName = 256;

/// Returns a name or text from outside as it is shown in messages: cut, and without control
/// characters.
std::string shown(const std::string& text, std::size_t max_length = 80);

/// Returns a transform as a pose; its quaternion need not have unit length.
Pose pose_of(const geometry_msgs::Transform& transform);

/// Returns a pose; nothing if a number is not finite or the length of the quaternion is more than
/// 1 % off.
std::optional<Pose> pose_of(const geometry_msgs::Pose& message);

/// Returns a pose as a message.
geometry_msgs::Pose pose_message(const Pose& pose);
/// Returns a pose as a transform.
geometry_msgs::Transform transform_message(const Pose& pose);
/// Returns a point as a message.
geometry_msgs::Point point_message(const Eigen::Vector3d& point);
/// Returns a vector as a message.
geometry_msgs::Vector3 vector_message(const Eigen::Vector3d& vector);

/// Returns what is wrong with a scan; nothing if its beams can be used.
std::optional<std::string> find_defect(const sensor_msgs::LaserScan& scan);
/// Returns how many beams angle_max counts beyond the ranges that there are. It is 1 with drivers
/// for which angle_max is the angle of the beam after the last one. Beams are placed by angle_min
/// and angle_increment alone, as laser_geometry does.
double missing_beams(const sensor_msgs::LaserScan& scan);
/// Returns the beams of a scan. A range_max of 0 is taken as not set: there is then no limit.
LaserBeams beams_of(const sensor_msgs::LaserScan& scan);

/// Returns a trajectory as a path in `frame`, stamped `stamp`; each pose keeps its own stamp.
nav_msgs::Path path_message(const std::vector<StampedPose>& trajectory, const std::string& frame,
                            Time stamp);

/// Returns the poses of a path with their own stamps. Throws std::invalid_argument that says what
/// is wrong if the path is empty or not in `frame`, or if a pose is not finite or not later than
/// the one before.
std::vector<StampedPose> trajectory_of(const nav_msgs::Path& path, const std::string& frame);

}  // namespace ribbon_mapper
