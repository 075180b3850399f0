// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <string>

#include "modeler/ros/messages/plane_markers.hpp"
#include "modeler/ros/node/model_keeper.hpp"

namespace ribbon_mapper {

/// Publishes the model on ~planes, ~markers, ~markers_before, ~cloud, ~rooms, ~room_markers,
/// ~trajectory and ~trajectory_before. Publishes only changes, and what is made of planes only
/// while somebody subscribes to it.
class ModelPublisher {
 public:
  /// Advertises the topics.
  ModelPublisher(ros::NodeHandle& private_node, std::string map_frame);

  /// Publishes what has changed since the last call; to be called about once a second. `done` is
  /// the stamp of the last line handled: it stamps the trajectory and shows how far the model is.
  void publish(ModelKeeper& keeper, Time done);

 private:
  std_msgs::Header header() const;
  void publish_planes(ModelKeeper& keeper);
  void publish_rooms(ModelKeeper& keeper, bool at_once);
  void publish_before(const ModelKeeper& keeper);

  std::string map_frame_;
  ros::Publisher planes_, markers_, markers_before_, cloud_, rooms_, room_markers_;
  ros::Publisher trajectory_, trajectory_before_;
  PlaneMarkers plane_markers_;
  std::size_t version_ = 0, revision_ = 0, rooms_version_ = 0;
  ros::WallTime rooms_at_;
  Time done_{-1};
  bool all_again_ = true;  ///< for a new subscriber
};

}  // namespace ribbon_mapper
