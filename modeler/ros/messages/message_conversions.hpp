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

#include <optional>
#include <string>
#include <vector>

#include "modeler/scan/laser_beams.hpp"

namespace ribbon_mapper {

Time time_of(const ros::Time& stamp);
ros::Time stamp_of(Time time);

/// Bags of before tf2 have frames with a leading slash, which tf2 refuses.
std::string without_slash(const std::string& frame);

Pose pose_of(const geometry_msgs::Transform& transform);

/// Nothing if a number is not finite or the quaternion is further than 1 % from unit length.
std::optional<Pose> pose_of(const geometry_msgs::Pose& message);

geometry_msgs::Pose pose_message(const Pose& pose);
geometry_msgs::Transform transform_message(const Pose& pose);
geometry_msgs::Point point_message(const Eigen::Vector3d& point);
geometry_msgs::Vector3 vector_message(const Eigen::Vector3d& vector);

/// What is wrong with a scan as a message; nothing if its beams can be looked at.
std::optional<std::string> find_defect(const sensor_msgs::LaserScan& scan);
LaserBeams beams_of(const sensor_msgs::LaserScan& scan);

nav_msgs::Path path_message(const std::vector<StampedPose>& trajectory, const std::string& frame,
                            Time stamp);

/// Poses with their own stamps. Throws std::invalid_argument that says what is wrong if the path is
/// empty or not in `frame`, or if a pose is not finite or not later than the one before.
std::vector<StampedPose> trajectory_of(const nav_msgs::Path& path, const std::string& frame);

}  // namespace ribbon_mapper
