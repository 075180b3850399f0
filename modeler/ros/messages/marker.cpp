// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/messages/marker.hpp"

#include <cmath>

#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

void add_ring(const std::vector<Eigen::Vector3d>& ring, const Eigen::Vector3d& shift,
              visualization_msgs::Marker& marker) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    add_line(ring[i] + shift, ring[(i + 1) % ring.size()] + shift, marker);
  }
}

}  // namespace

visualization_msgs::Marker new_marker(std::int32_t type, const std_msgs::Header& header,
                                      const std::string& ns, std::int64_t id) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = ns;
  marker.id = static_cast<std::int32_t>(id);
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color.a = 1.0F;
  return marker;
}

std_msgs::ColorRGBA colour_message(const Colour& colour, double shade, double alpha) {
  std_msgs::ColorRGBA message;
  message.r = static_cast<float>(shade * colour.red / 255.0);
  message.g = static_cast<float>(shade * colour.green / 255.0);
  message.b = static_cast<float>(shade * colour.blue / 255.0);
  message.a = static_cast<float>(alpha);
  return message;
}

std_msgs::ColorRGBA shaded(const Colour& colour, const Eigen::Vector3d& normal) {
  return colour_message(colour,
                        0.66 + 0.34 * std::abs(normal.dot(Eigen::Vector3d(0.3, 0.6, 0.74))));
}

void add_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
              visualization_msgs::Marker& marker) {
  marker.points.push_back(point_message(a));
  marker.points.push_back(point_message(b));
}

void add_sides(const std::vector<Outline>& outlines, const Eigen::Vector3d& shift,
               visualization_msgs::Marker& marker) {
  for (const Outline& outline : outlines) {
    add_ring(outline.outer, shift, marker);
    for (const auto& hole : outline.holes) add_ring(hole, shift, marker);
  }
}

}  // namespace ribbon_mapper
