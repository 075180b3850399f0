// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/plane_markers.hpp"

#include <functional>

#include "modeler/io/colour.hpp"
#include "modeler/ros/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

visualization_msgs::Marker triangles(const std_msgs::Header& header, const std::string& ns,
                                     std::int64_t id) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = ns;
  marker.id = static_cast<std::int32_t>(id);
  marker.type = visualization_msgs::Marker::TRIANGLE_LIST;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  return marker;
}

void add_surface(const Plane& plane, visualization_msgs::Marker& marker) {
  for (const CellRectangle& r : surface_rectangles(plane)) {
    const geometry_msgs::Point a = point_message(grid_corner(plane, r.u_begin, r.v_begin));
    const geometry_msgs::Point b = point_message(grid_corner(plane, r.u_end, r.v_begin));
    const geometry_msgs::Point c = point_message(grid_corner(plane, r.u_end, r.v_end));
    const geometry_msgs::Point d = point_message(grid_corner(plane, r.u_begin, r.v_end));
    marker.points.insert(marker.points.end(), {a, b, c, a, c, d});
  }
}

std_msgs::ColorRGBA opaque(const Colour& colour) {
  std_msgs::ColorRGBA message;
  message.r = colour.red / 255.0F;
  message.g = colour.green / 255.0F;
  message.b = colour.blue / 255.0F;
  message.a = 1.0F;
  return message;
}

std::size_t hash_of(const visualization_msgs::Marker& marker) {
  std::size_t hash = marker.points.size();
  for (const geometry_msgs::Point& point : marker.points) {
    for (const double value : {point.x, point.y, point.z})
      hash = hash * 1099511628211u + std::hash<double>()(value);
  }
  return hash;
}

}  // namespace

visualization_msgs::MarkerArray PlaneMarkers::changes(const std::vector<Plane>& planes,
                                                      const std_msgs::Header& header) {
  visualization_msgs::MarkerArray array;
  std::map<std::int64_t, std::size_t> now;
  for (const Plane& plane : planes) {
    visualization_msgs::Marker marker = triangles(header, "planes", plane.id);
    add_surface(plane, marker);
    if (marker.points.empty()) continue;  // rviz complains about a marker without points
    marker.color = opaque(plane_colour(plane.id));
    const std::size_t hash = now[plane.id] = hash_of(marker);
    const auto sent = sent_.find(plane.id);
    if (sent == sent_.end() || sent->second != hash) array.markers.push_back(std::move(marker));
  }
  for (const auto& [id, hash] : sent_) {
    if (now.count(id) != 0) continue;
    array.markers.push_back(triangles(header, "planes", id));
    array.markers.back().action = visualization_msgs::Marker::DELETE;
  }
  sent_ = std::move(now);
  return array;
}

visualization_msgs::MarkerArray white_markers(const std::vector<Plane>& planes,
                                              const std_msgs::Header& header) {
  visualization_msgs::Marker marker = triangles(header, "before_correction", 0);
  for (const Plane& plane : planes) add_surface(plane, marker);
  if (marker.points.empty()) marker.action = visualization_msgs::Marker::DELETE;
  marker.color = opaque({255, 255, 255});
  visualization_msgs::MarkerArray array;
  array.markers.push_back(std::move(marker));
  return array;
}

}  // namespace ribbon_mapper
