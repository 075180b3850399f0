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
#include <memory>
#include <set>
#include <string>

#include "modeler/ros/intake/run_sorter.hpp"
#include "modeler/ros/messages/transform_entry.hpp"

namespace ribbon_mapper {

/// A tf2 buffer with the transforms of one run of simulated time, and all static ones.
class TransformBuffer {
 public:
  /// Called with each moving transform that enters the buffer.
  using Listener = std::function<void(const geometry_msgs::TransformStamped&)>;

  /// Creates an empty buffer that reaches back `cache_s`. Transforms whose parent is one of
  /// `drop_frames` are left out, see enter_transforms().
  TransformBuffer(double cache_s, std::set<std::string> drop_frames, Listener listener = {});

  /// Adds the transforms of a message. Those of the next run are held back until start_next_run(),
  /// those of the previous run are dropped. A frame that is both static and moving moves: its
  /// static transform is taken out, and with it the moving ones of before.
  void add(const tf2_msgs::TFMessage& message, bool is_static);

  /// Replaces the moving transforms by those held back. Static transforms stay: latched messages
  /// are not sent again.
  void start_next_run();

  /// Returns the tf2 buffer for lookups. Not to be kept: it may be replaced by any message.
  const tf2::BufferCore& core() const { return *buffer_; }
  /// Returns what became of the transforms.
  const TransformCounts& counts() const { return counts_; }
  /// Returns the frames that are both static and moving.
  const std::set<std::string>& contradicted() const { return contradicted_; }
  /// Returns how long after its stamp the newest transform of a frame came; 0 for one that is
  /// static or unknown.
  double delay_s(const std::string& child) const;
  /// Returns the number of transforms received.
  std::size_t received() const { return received_; }

 private:
  struct Held {
    geometry_msgs::TransformStamped transform;
    ros::WallTime arrived;
  };
  bool is_used(const geometry_msgs::TransformStamped& transform) const;
  void enter(const tf2_msgs::TFMessage& message);
  void enter_expired();
  void enter_static(const tf2_msgs::TFMessage& message);
  void take_out_static(const tf2_msgs::TFMessage& moving);

  double cache_s_;
  std::unique_ptr<tf2::BufferCore> buffer_;
  std::map<std::string, geometry_msgs::TransformStamped> fixed_;  ///< static ones, by child
  std::set<std::string> contradicted_;
  std::map<std::string, double> delays_s_;  ///< of moving frames, by child
  TransformCounts counts_;
  std::set<std::string> drop_frames_;
  Listener listener_;
  std::map<std::string, RunSorter> sorters_;  ///< by child frame
  std::deque<Held> held_;                     ///< of the next run, in order of arrival
  std::size_t received_ = 0;
};

}  // namespace ribbon_mapper
