// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/GetMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ribbon_mapper/Save.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <filesystem>
#include <string>
#include <vector>

#include "modeler/modeler.hpp"
#include "modeler/ros/maps/map_worker.hpp"
#ifdef RIBBON_MAPPER_WITH_OCTOMAP_MSGS
#include <octomap_msgs/GetOctomap.h>
#endif

namespace ribbon_mapper {

/// What a MapServer needs to know.
struct MapServerOptions {
  std::string frame = "map";                   ///< of all maps
  std::filesystem::path directory = "models";  ///< where ~save_map writes
  double period_s = 10.0;                      ///< shortest time between two maps on the topic
  MapsConfig maps;                             ///< how maps are made
};

/// Offers the maps for robots: latched ~map, ~get_map and ~save_map, and ~get_octomap where
/// octomap_msgs was found. They are made by another thread and cost nothing while nobody subscribes
/// or calls. Services have a thread of their own, which waits for the maps.
class MapServer {
 public:
  /// Advertises topic and services.
  MapServer(const ros::NodeHandle& private_node, const MapServerOptions& options);
  /// Ends all calls.
  ~MapServer();
  MapServer(const MapServer&) = delete;
  MapServer& operator=(const MapServer&) = delete;

  /// Returns true if a map of the model is wanted now: somebody has called, or somebody subscribes
  /// and the model was corrected, or has changed since the period began. `version` counts all
  /// changes, `revision` the corrections.
  bool wants_model(std::size_t version, std::size_t revision);

  /// Copies what maps are made from. `model` is the modeler's.
  void give(const Modeler& modeler, const PlaneModel& model);

 private:
  bool on_get_map(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& response);
  bool on_save_map(Save::Request& request, Save::Response& response);
#ifdef RIBBON_MAPPER_WITH_OCTOMAP_MSGS
  bool on_get_octomap(octomap_msgs::GetOctomap::Request&,
                      octomap_msgs::GetOctomap::Response& response);
#endif
  nav_msgs::OccupancyGrid message_of(const NavigationMap& map) const;
  std::vector<std::filesystem::path> save(const std::string& name);

  MapServerOptions options_;
  ros::Publisher topic_;
  MapWorker worker_;
  ros::CallbackQueue calls_;
  ros::NodeHandle calls_node_;
  std::vector<ros::ServiceServer> services_;
  ros::AsyncSpinner spinner_{1, &calls_};
  ros::WallTime given_at_;
  std::size_t given_version_ = 0, given_revision_ = 0, version_ = 0, revision_ = 0;
};

}  // namespace ribbon_mapper
