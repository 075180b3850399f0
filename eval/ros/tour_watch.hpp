// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <ribbon_mapper/GetModel.h>
#include <ribbon_mapper/PlaneArray.h>
#include <ros/node_handle.h>
#include <ros/time.h>
#include <std_msgs/Bool.h>

#include <cstddef>
#include <string>
#include <vector>

#include "eval/results/results.hpp"
#include "sim/ros/pose_history.hpp"

namespace ribbon_mapper::eval {

/// Follows a tour over ROS from its first line until the model is corrected.
class TourWatch {
 public:
  /// Subscribes to the topics of the simulator and of the modeler.
  TourWatch();

  /// Polls the modeler's state. To be called about once a second.
  void look();

  /// Returns true once the simulator has announced the end of the tour.
  bool tour_finished() const { return finished_; }

  /// Returns the wall clock time since the last line or correction [s].
  double idle_s() const;

  /// Returns a progress message of one line.
  std::string progress() const;

  /// Describes what is still missing for results. Empty when everything has arrived.
  std::string missing() const;

  /// Fetches the four models and the trajectories; `surface` is the modeler's configuration. Throws
  /// std::runtime_error if the modeler does not answer.
  Results results(const SurfaceConfig& surface);

 private:
  void on_correction(const nav_msgs::Path& path);
  GetModel::Response model(bool before_correction, bool as_built, bool with_cells);
  bool is_corrected() const;
  bool shows_latest_correction() const;
  double speed() const;

  ros::NodeHandle node_;
  ros::ServiceClient get_model_;
  ros::Subscriber finished_topic_, corrected_topic_, correction_, truth_planes_topic_, truth_poses_;
  ros::Subscriber trajectory_topic_, trajectory_before_topic_;

  bool finished_ = false, corrected_ = false;   ///< as announced
  std::size_t corrections_ = 0;                 ///< number of corrections sent to the modeler
  geometry_msgs::PoseStamped corrected_until_;  ///< the last pose of the latest one
  PlaneArray::ConstPtr truth_planes_;
  PoseHistory truth_;
  nav_msgs::Path::ConstPtr trajectory_, trajectory_before_;

  GetModel::Response state_;      ///< latest answer, without cells
  bool revision_is_new_ = false;  ///< the trajectory may still be in transit
  ros::WallTime last_news_ = ros::WallTime::now(), first_line_wall_;
  ros::Time first_line_, last_line_;
};

}  // namespace ribbon_mapper::eval
