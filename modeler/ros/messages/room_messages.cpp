// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/messages/room_messages.hpp"

#include <array>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "modeler/mesh/plane_mesh.hpp"
#include "modeler/ros/messages/marker.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/messages/plane_messages.hpp"

namespace ribbon_mapper {
namespace {

using visualization_msgs::Marker;

constexpr double kFloorAlpha = 0.35;  // the floor shows through
constexpr double kAboveFloor_m = 0.02;
constexpr double kNameAbove_m = 1.3;  // above the label of the floor
constexpr double kNameLetter_m = 0.28;
constexpr double kFrame_m = 0.08;  // thickness of a passage's lines
constexpr Colour kPassage{214, 122, 56};
/// Soft and light, so that furniture and trajectories stand out.
constexpr std::array<Colour, 6> kFloors{{{143, 179, 207},
                                         {169, 198, 163},
                                         {220, 189, 159},
                                         {185, 169, 204},
                                         {207, 195, 143},
                                         {216, 173, 174}}};

/// Returns the corners of triangles, three for each; none if GLU cannot make any.
std::vector<Eigen::Vector3d> corners_of_triangles(const Plane& plane) {
  std::vector<Eigen::Vector3d> corners;
  try {
    const PlaneMesh mesh = mesh_of(plane);
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) corners.push_back(mesh.vertices[corner]);
    }
  } catch (const std::runtime_error&) {
    corners.clear();
  }
  return corners;
}

Marker floor_marker(const Room& room, std::size_t index, const std_msgs::Header& header) {
  Marker marker =
      new_marker(Marker::TRIANGLE_LIST, header, "rooms", static_cast<std::int64_t>(index));
  Plane floor;
  floor.outlines = floor_outlines(room);
  for (const Eigen::Vector3d& corner : corners_of_triangles(floor)) {
    marker.points.push_back(point_message(corner + kAboveFloor_m * Eigen::Vector3d::UnitZ()));
  }
  marker.color = colour_message(kFloors[index % kFloors.size()], 1.0, kFloorAlpha);
  return marker;
}

Marker name_marker(const Room& room, std::size_t index, const std_msgs::Header& header) {
  Marker marker =
      new_marker(Marker::TEXT_VIEW_FACING, header, "names", static_cast<std::int64_t>(index));
  marker.pose.position = point_message(room.centre + kNameAbove_m * Eigen::Vector3d::UnitZ());
  marker.scale.z = kNameLetter_m;
  marker.color = colour_message({255, 255, 255});
  std::array<char, 64> area;
  std::snprintf(area.data(), area.size(), "\n%.1f m2", room.area_m2);
  marker.text = "room " + room_name(index) + area.data();
  return marker;
}

Marker passages_marker(const std::vector<Passage>& passages, const std_msgs::Header& header) {
  Marker marker = new_marker(Marker::LINE_LIST, header, "passages", 0);
  marker.scale.x = kFrame_m;
  marker.color = colour_message(kPassage);
  for (const Passage& passage : passages) {
    const auto& [a, b] = passage.opening.jambs;
    add_line(a, b, marker);
    if (!passage.opening.head_m) continue;
    const Eigen::Vector3d top_a(a.x(), a.y(), *passage.opening.head_m);
    const Eigen::Vector3d top_b(b.x(), b.y(), *passage.opening.head_m);
    add_line(a, top_a, marker);
    add_line(b, top_b, marker);
    add_line(top_a, top_b, marker);
  }
  return marker;
}

FloorPassage passage_message(const Passage& passage) {
  FloorPassage message;
  message.rooms = {static_cast<std::uint32_t>(passage.rooms[0]),
                   static_cast<std::uint32_t>(passage.rooms[1])};
  message.plane = passage.opening.plane;
  for (std::size_t i = 0; i < 2; ++i) message.jambs[i] = point_message(passage.opening.jambs[i]);
  message.head = passage.opening.head_m.value_or(std::numeric_limits<double>::quiet_NaN());
  message.confidence = passage.opening.confidence;
  return message;
}

}  // namespace

FloorRooms rooms_message(const Rooms& rooms, const std_msgs::Header& header, std::size_t revision) {
  FloorRooms message;
  message.header = header;
  message.revision = static_cast<std::uint32_t>(revision);
  for (std::size_t i = 0; i < rooms.rooms.size(); ++i) {
    FloorRoom& room = message.rooms.emplace_back();
    room.name = room_name(i);
    room.area = rooms.rooms[i].area_m2;
    room.centre = point_message(rooms.rooms[i].centre);
    room.outlines = outline_messages(floor_outlines(rooms.rooms[i]));
  }
  for (const Passage& passage : rooms.passages) {
    message.passages.push_back(passage_message(passage));
  }
  return message;
}

visualization_msgs::MarkerArray room_markers(const Rooms& rooms, const std_msgs::Header& header) {
  visualization_msgs::MarkerArray array;
  array.markers.push_back(new_marker(Marker::CUBE, header, "", 0));
  array.markers.back().action = Marker::DELETEALL;
  for (std::size_t i = 0; i < rooms.rooms.size(); ++i) {
    Marker floor = floor_marker(rooms.rooms[i], i, header);
    if (!floor.points.empty()) array.markers.push_back(std::move(floor));
    array.markers.push_back(name_marker(rooms.rooms[i], i, header));
  }
  // rviz complains about a marker without points.
  if (!rooms.passages.empty()) array.markers.push_back(passages_marker(rooms.passages, header));
  return array;
}

}  // namespace ribbon_mapper
