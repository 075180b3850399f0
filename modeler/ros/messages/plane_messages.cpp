// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/messages/plane_messages.hpp"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>

#include "modeler/io/planes_json.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/messages/plane_markers.hpp"

namespace ribbon_mapper {
namespace {

geometry_msgs::Point32 point32_message(const Eigen::Vector3d& point) {
  const Eigen::Vector3f single = point.cast<float>();
  geometry_msgs::Point32 message;
  message.x = single.x(), message.y = single.y(), message.z = single.z();
  return message;
}

geometry_msgs::Polygon polygon_message(const std::vector<Eigen::Vector3d>& ring) {
  geometry_msgs::Polygon message;
  for (const Eigen::Vector3d& corner : ring) message.points.push_back(point32_message(corner));
  return message;
}

BoundedPlane plane_message(const Plane& plane, bool with_cells) {
  BoundedPlane message;
  message.id = plane.id;
  message.normal = vector_message(plane.normal);
  message.d = plane.d_m;
  message.area = plane.area_m2;
  message.ribbon_count = static_cast<std::uint32_t>(plane.ribbons.size());
  message.centroid = point_message(plane.centroid);
  const Eigen::AlignedBox3d box = bounding_box(plane);
  message.bbox_min = point_message(box.min());
  message.bbox_max = point_message(box.max());
  message.outlines = outline_messages(plane.outlines);
  for (int i = 0; i < 9; ++i) message.covariance[i] = plane.covariance(i / 3, i % 3);
  message.axis_u = vector_message(plane.axis_u);
  message.axis_v = vector_message(plane.axis_v);
  message.cell_size = plane.cell_size_m;
  if (!with_cells) return message;
  for (const PlaneCell& cell : plane.cells)
    message.cells.push_back(point32_message(cell_centre(plane, cell)));
  return message;
}

}  // namespace

std::vector<PlaneOutline> outline_messages(const std::vector<Outline>& outlines) {
  std::vector<PlaneOutline> messages;
  for (const Outline& outline : outlines) {
    PlaneOutline& message = messages.emplace_back();
    message.outer = polygon_message(outline.outer);
    for (const auto& hole : outline.holes) message.holes.push_back(polygon_message(hole));
  }
  return messages;
}

PlaneArray plane_array_message(const std::vector<Plane>& planes, const std_msgs::Header& header,
                               std::size_t revision, bool with_cells,
                               const std::vector<PlaneLabel>& labels) {
  PlaneArray message;
  message.header = header;
  message.revision = static_cast<std::uint32_t>(revision);
  for (const Plane& plane : planes) message.planes.push_back(plane_message(plane, with_cells));
  for (std::size_t i = 0; i < std::min(planes.size(), labels.size()); ++i) {
    message.planes[i].label = labels[i].text;
    message.planes[i].label_confidence = labels[i].confidence;
    message.planes[i].note = labels[i].note;
  }
  return message;
}

sensor_msgs::PointCloud2 cell_cloud(const std::vector<Plane>& planes,
                                    const std::vector<PlaneLabel>& labels,
                                    const std_msgs::Header& header) {
  std::size_t count = 0;
  for (const Plane& plane : planes) count += plane.cells.size();
  sensor_msgs::PointCloud2 cloud;
  cloud.header = header;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(2, "xyz", "rgb");
  modifier.resize(count);
  sensor_msgs::PointCloud2Iterator<float> xyz(cloud, "x");
  sensor_msgs::PointCloud2Iterator<std::uint8_t> bgr(cloud, "rgb");
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Plane& plane = planes[i];
    const Colour colour = shown_colour(plane, labels.at(i).rule);
    for (const PlaneCell& cell : plane.cells) {
      const Eigen::Vector3f centre = cell_centre(plane, cell).cast<float>();
      for (int axis = 0; axis < 3; ++axis) xyz[axis] = centre[axis];
      bgr[0] = colour.blue, bgr[1] = colour.green, bgr[2] = colour.red;
      ++xyz, ++bgr;
    }
  }
  return cloud;
}

}  // namespace ribbon_mapper
