// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/maps/map_server.hpp"

#include <algorithm>
#include <stdexcept>

#include "modeler/io/octomap.hpp"
#include "modeler/io/save.hpp"
#include "modeler/map_files/map_files.hpp"
#include "modeler/observations/observations.hpp"

namespace ribbon_mapper {
namespace {

constexpr const char* kEnding = "the node is ending, or the map could not be made";

}  // namespace

MapServer::MapServer(const ros::NodeHandle& private_node, const MapServerOptions& options)
    : options_(options),
      topic_(ros::NodeHandle(private_node).advertise<nav_msgs::OccupancyGrid>("map", 1, true)),
      worker_(options.maps,
              [this](const ModelMaps& maps) { topic_.publish(message_of(maps.level)); }),
      calls_node_(private_node) {
  calls_node_.setCallbackQueue(&calls_);
  services_ = {calls_node_.advertiseService("get_map", &MapServer::on_get_map, this),
               calls_node_.advertiseService("save_map", &MapServer::on_save_map, this)};
#ifdef RIBBON_MAPPER_WITH_OCTOMAP_MSGS
  services_.push_back(
      calls_node_.advertiseService("get_octomap", &MapServer::on_get_octomap, this));
#endif
  spinner_.start();
}

MapServer::~MapServer() {
  worker_.close();
  spinner_.stop();
}

bool MapServer::wants_model(std::size_t version, std::size_t revision) {
  version_ = version, revision_ = revision;
  if (worker_.is_asked()) return true;
  if (version == given_version_ || topic_.getNumSubscribers() == 0) return false;
  const bool is_due = (ros::WallTime::now() - given_at_).toSec() >= options_.period_s;
  return is_due || revision != given_revision_;
}

void MapServer::give(const Modeler& modeler, const PlaneModel& model) {
  given_version_ = version_, given_revision_ = revision_;
  given_at_ = ros::WallTime::now();
  worker_.give({model.planes, sight_lines_of(modeler.observations().posed(), model, options_.maps,
                                             origin_of(model.planes))});
}

bool MapServer::on_get_map(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& response) {
  const auto maps = worker_.wait_for(worker_.ask());
  if (!maps) return false;
  response.map = message_of(maps->level);
  return true;
}

bool MapServer::on_save_map(Save::Request& request, Save::Response& response) {
  try {
    response.message = "written:";
    for (const auto& file : save(request.name)) response.message += " " + file.string();
    response.success = true;
  } catch (const std::exception& error) {
    response.message = error.what();
    response.success = false;
    ROS_ERROR("Map not saved: %s", error.what());
  }
  return true;
}

std::vector<std::filesystem::path> MapServer::save(const std::string& name) {
  check_save_name(name);
  const auto maps = worker_.wait_for(worker_.ask());
  if (!maps) throw std::runtime_error(kEnding);
  ModelLabel label;
  label.frame = options_.frame;
  label.run = run_id_of({navigation_map_to_pgm(maps->level), octomap_data(maps->voxels)});
  FileSet files(options_.directory, name + "_map");
  add_maps(*maps, label, name + "_map", files);
  return files.commit();
}

#ifdef RIBBON_MAPPER_WITH_OCTOMAP_MSGS
bool MapServer::on_get_octomap(octomap_msgs::GetOctomap::Request&,
                               octomap_msgs::GetOctomap::Response& response) {
  const auto maps = worker_.wait_for(worker_.ask());
  if (!maps) return false;
  if (!maps->voxels.origin().isZero(0.0)) {
    ROS_ERROR(
        "The model lies more than 1 km from the origin of %s, where an Octomap message is "
        "too coarse: call ~save_map, whose file states its own origin",
        options_.frame.c_str());
    return false;
  }
  response.map.header.frame_id = options_.frame;
  response.map.header.stamp = ros::Time::now();
  response.map.binary = 1;
  response.map.id = "OcTree";
  response.map.resolution = maps->voxels.voxel_m();
  const std::string data = octomap_data(maps->voxels);
  response.map.data.assign(data.begin(), data.end());
  return true;
}
#endif

nav_msgs::OccupancyGrid MapServer::message_of(const NavigationMap& map) const {
  nav_msgs::OccupancyGrid message;
  message.header.frame_id = options_.frame;
  message.header.stamp = message.info.map_load_time = ros::Time::now();
  message.info.resolution = static_cast<float>(map.cell_m);
  message.info.width = static_cast<std::uint32_t>(map.width);
  message.info.height = static_cast<std::uint32_t>(map.height);
  message.info.origin.position.x = map.corner_m.x();
  message.info.origin.position.y = map.corner_m.y();
  message.info.origin.orientation.w = 1.0;
  message.data = map.cells;
  return message;
}

}  // namespace ribbon_mapper
