// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/LaserScan.h>

#include <string>

#include "sim/robot/hokuyo.hpp"
#include "sim/tour/route.hpp"

namespace ribbon_mapper::sim {

// Messages of a simulated PR2.

constexpr const char* kTiltLaserFrame = "laser_tilt_link";  ///< of the tilting laser
constexpr const char* kBaseLaserFrame = "base_laser_link";  ///< of the laser on the base

/// Returns a scan of the laser whose frame is `frame` as a message.
sensor_msgs::LaserScan scan_message(const Scan& scan, const std::string& frame,
                                    const ros::Time& stamp);

/// Returns the positions of the torso (at rest) and the tilt.
sensor_msgs::JointState joint_message(double tilt_rad, const ros::Time& stamp);

/// Returns the pose of `child` in `parent` as a transform for tf.
geometry_msgs::TransformStamped stamped_transform(const std::string& parent,
                                                  const std::string& child, const Pose& pose,
                                                  const ros::Time& stamp);

/// Returns pose and velocity of `child` in `parent`.
nav_msgs::Odometry odometry_message(const std::string& parent, const std::string& child,
                                    const Pose& pose, const Velocity& velocity,
                                    const ros::Time& stamp);

}  // namespace ribbon_mapper::sim
