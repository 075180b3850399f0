// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/node/model_publisher.hpp"

#include <utility>

#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/messages/plane_messages.hpp"
#include "modeler/ros/messages/room_messages.hpp"

namespace ribbon_mapper {
namespace {

/// Rooms cost as much as planes do, and change less: shortest time between two messages, unless a
/// correction comes.
constexpr double kRoomsPeriod_s = 5.0;

bool is_wanted(const ros::Publisher& topic) { return topic.getNumSubscribers() > 0; }

}  // namespace

ModelPublisher::ModelPublisher(ros::NodeHandle& private_node, std::string map_frame)
    : map_frame_(std::move(map_frame)) {
  // A new subscriber gets everything with the next call: a latched message may be outdated.
  const ros::SubscriberStatusCallback greet = [this](const ros::SingleSubscriberPublisher&) {
    all_again_ = true;
  };
  const auto advertise = [&](auto message, const char* topic, bool latch) {
    return private_node.advertise<decltype(message)>(topic, 2, greet, {}, {}, latch);
  };
  planes_ = advertise(PlaneArray(), "planes", true);
  // Not latched: the last message has only the last changes.
  markers_ = advertise(visualization_msgs::MarkerArray(), "markers", false);
  markers_before_ = advertise(visualization_msgs::MarkerArray(), "markers_before", true);
  cloud_ = advertise(sensor_msgs::PointCloud2(), "cloud", true);
  rooms_ = advertise(FloorRooms(), "rooms", true);
  room_markers_ = advertise(visualization_msgs::MarkerArray(), "room_markers", true);
  trajectory_ = advertise(nav_msgs::Path(), "trajectory", true);
  trajectory_before_ = advertise(nav_msgs::Path(), "trajectory_before", true);
}

std_msgs::Header ModelPublisher::header() const {
  std_msgs::Header header;
  header.frame_id = map_frame_;
  header.stamp = ros::Time::now();
  return header;
}

void ModelPublisher::publish(ModelKeeper& keeper, Time done) {
  const bool all = std::exchange(all_again_, false);
  if (all) plane_markers_.forget();
  if (all || version_ != keeper.version()) publish_planes(keeper);
  const std::size_t revision = keeper.modeler().statistics().revision;
  if (all || revision_ != revision) publish_before(keeper);
  publish_rooms(keeper, all || revision_ != revision);
  if ((all || version_ != keeper.version() || done_ != done) && is_wanted(trajectory_))
    trajectory_.publish(path_message(keeper.modeler().trajectory(), map_frame_, done));
  version_ = keeper.version();
  revision_ = revision;
  done_ = done;
}

void ModelPublisher::publish_planes(ModelKeeper& keeper) {
  if (!is_wanted(planes_) && !is_wanted(markers_) && !is_wanted(cloud_)) return;
  const std::vector<Plane>& planes = keeper.planes();
  const std::size_t revision = keeper.modeler().statistics().revision;
  if (is_wanted(planes_))
    planes_.publish(plane_array_message(planes, header(), revision, false, keeper.labels()));
  if (is_wanted(markers_))
    markers_.publish(
        plane_markers_.changes(planes, keeper.labels(), keeper.stripe_gap_m(), header()));
  if (is_wanted(cloud_)) cloud_.publish(cell_cloud(planes, keeper.labels(), header()));
}

void ModelPublisher::publish_rooms(ModelKeeper& keeper, bool at_once) {
  if (!is_wanted(rooms_) && !is_wanted(room_markers_)) return;
  const ros::WallTime now = ros::WallTime::now();
  const bool is_due =
      rooms_version_ != keeper.version() && (now - rooms_at_).toSec() >= kRoomsPeriod_s;
  if (!at_once && !is_due) return;
  rooms_version_ = keeper.version();
  rooms_at_ = now;
  if (is_wanted(rooms_))
    rooms_.publish(rooms_message(keeper.rooms(), header(), keeper.modeler().statistics().revision));
  if (is_wanted(room_markers_)) room_markers_.publish(room_markers(keeper.rooms(), header()));
}

void ModelPublisher::publish_before(const ModelKeeper& keeper) {
  markers_before_.publish(white_markers(keeper.before().planes, keeper.stripe_gap_m(), header()));
  trajectory_before_.publish(path_message(keeper.before().trajectory, map_frame_, Time(0)));
}

}  // namespace ribbon_mapper
