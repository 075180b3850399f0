// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "modeler/ros/intake/run_sorter.hpp"

namespace ribbon_mapper {

/// A tf2 buffer with the transforms of one run of simulated time, and all static ones.
class TransformBuffer {
 public:
  /// Called with each moving transform that enters the buffer.
  using Listener = std::function<void(const geometry_msgs::TransformStamped&)>;

  /// Creates an empty buffer that reaches back `cache_s`. Transforms whose parent is one of
  /// `drop_frames` are left out, see enter_transforms().
  TransformBuffer(double cache_s, std::set<std::string> drop_frames, Listener listener = {});

  /// Adds the transforms of a message and returns how many of them were unusable. Those of the next
  /// run are held back until start_next_run(), those of the previous run are dropped.
  std::size_t add(const tf2_msgs::TFMessage& message, bool is_static);

  /// Replaces the moving transforms by those held back. Static transforms stay: latched messages
  /// are not sent again.
  void start_next_run();

  /// Returns the tf2 buffer for lookups.
  const tf2::BufferCore& core() const { return buffer_; }
  /// Returns the number of transforms received.
  std::size_t received() const { return received_; }

 private:
  struct Held {
    geometry_msgs::TransformStamped transform;
    ros::WallTime arrived;
  };
  std::size_t enter(const tf2_msgs::TFMessage& message);
  std::size_t enter_expired();

  tf2::BufferCore buffer_;
  std::set<std::string> drop_frames_;
  Listener listener_;
  std::map<std::string, RunSorter> sorters_;  ///< by child frame
  std::deque<Held> held_;                     ///< of the next run, in order of arrival
  std::size_t received_ = 0;
};

}  // namespace ribbon_mapper
