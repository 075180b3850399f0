// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/ros/truth_messages.hpp"

#include <Eigen/Geometry>

#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper::sim {
namespace {

BoundedPlane plane_message(const TruthPlane& plane) {
  BoundedPlane message;
  message.id = plane.id;
  message.normal = vector_message(plane.normal);
  message.d = plane.d_m;
  message.area = plane.area_m2;
  message.cell_size = 0.05;
  Eigen::AlignedBox3d box;
  message.axis_u = vector_message(plane.axis_u);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& cell : plane.cells) {
    box.extend(cell);
    sum += cell;
    geometry_msgs::Point32 point;
    const Eigen::Vector3f single = cell.cast<float>();
    point.x = single.x(), point.y = single.y(), point.z = single.z();
    message.cells.push_back(point);
  }
  message.bbox_min = point_message(box.min());
  message.bbox_max = point_message(box.max());
  message.centroid = point_message(sum / static_cast<double>(plane.cells.size()));
  return message;
}

}  // namespace

PlaneArray truth_message(const std::vector<TruthPlane>& planes, const std_msgs::Header& header) {
  PlaneArray message;
  message.header = header;
  for (const TruthPlane& plane : planes) message.planes.push_back(plane_message(plane));
  return message;
}

visualization_msgs::MarkerArray world_markers(const World& world, const std_msgs::Header& header) {
  visualization_msgs::Marker lines;
  lines.header = header;
  lines.ns = "world";
  lines.type = visualization_msgs::Marker::LINE_LIST;
  lines.pose.orientation.w = 1.0;
  lines.scale.x = 0.02;
  lines.color.r = lines.color.g = lines.color.b = 0.55F;
  lines.color.a = 1.0F;
  for (const double z_m : {0.1, 1.0}) {
    for (const auto& segment : world.outlines_at(z_m)) {
      for (const Eigen::Vector2d& end : segment)
        lines.points.push_back(point_message({end.x(), end.y(), z_m}));
    }
  }
  visualization_msgs::MarkerArray array;
  if (!lines.points.empty()) array.markers.push_back(lines);
  return array;
}

}  // namespace ribbon_mapper::sim
