// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/messages/plane_markers.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

#include "modeler/io/colour.hpp"
#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

/// White planes lie this far behind coloured ones, so that they show only where the model has
/// moved.
constexpr double kWhiteBehind_m = 0.02;

/// White planes are pale, so that coloured ones show through them, as in figure 8 of the paper.
constexpr float kWhiteAlpha = 0.35F;
/// Texts stand this far before their planes, so that these do not hide them.
constexpr double kTextBefore_m = 0.1;
constexpr double kTextHeight_m = 0.2;  // readable in a view of a flat

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

/// Returns the colour of a surface, brighter the more it faces up or one diagonal; both sides
/// alike. rviz applies no light of its own to triangles with colours; it would leave back sides
/// black.
std_msgs::ColorRGBA shaded(const Colour& colour, const Eigen::Vector3d& normal) {
  const double shade = 0.66 + 0.34 * std::abs(normal.dot(Eigen::Vector3d(0.3, 0.6, 0.74)));
  std_msgs::ColorRGBA message;
  message.r = static_cast<float>(shade * colour.red / 255.0);
  message.g = static_cast<float>(shade * colour.green / 255.0);
  message.b = static_cast<float>(shade * colour.blue / 255.0);
  message.a = 1.0F;
  return message;
}

/// Adds the surface of a plane to a marker, drawn `behind_m` behind its front.
void add_surface(const Plane& plane, double stripe_gap_m, const Colour& colour, double behind_m,
                 visualization_msgs::Marker& marker) {
  const std_msgs::ColorRGBA shade = shaded(colour, plane.normal);
  const Eigen::Vector3d shift = -behind_m * plane.normal;
  const auto corner = [&](int u, int v) { return point_message(grid_corner(plane, u, v) + shift); };
  for (const CellRectangle& r : surface_rectangles(plane, stripe_gap_m)) {
    const geometry_msgs::Point a = corner(r.u_begin, r.v_begin), b = corner(r.u_end, r.v_begin);
    const geometry_msgs::Point c = corner(r.u_end, r.v_end), d = corner(r.u_begin, r.v_end);
    marker.points.insert(marker.points.end(), {a, b, c, a, c, d});
    marker.colors.insert(marker.colors.end(), 2, shade);
  }
  marker.color.a = 1.0F;
}

/// Returns a text with id, label and area before a plane.
visualization_msgs::Marker text_marker(const Plane& plane, const PlaneLabel& label,
                                       const std_msgs::Header& header) {
  visualization_msgs::Marker marker = triangles(header, "labels", plane.id);
  marker.type = visualization_msgs::Marker::TEXT_VIEW_FACING;
  marker.pose.position = point_message(plane.centroid + kTextBefore_m * plane.normal);
  marker.scale.z = kTextHeight_m;
  marker.color.r = marker.color.g = marker.color.b = marker.color.a = 1.0F;
  std::array<char, 200> text;
  std::snprintf(text.data(), text.size(), "%lld %s %.1f m2", static_cast<long long>(plane.id),
                label.text.c_str(), plane.area_m2);
  marker.text = text.data();
  return marker;
}

std::size_t hash_of(const visualization_msgs::Marker& marker) {
  std::size_t hash = marker.points.size();
  for (const geometry_msgs::Point& point : marker.points) {
    for (const double value : {point.x, point.y, point.z})
      hash = hash * 1099511628211u + std::hash<double>()(value);
  }
  return hash;
}

std::size_t hash_of(const visualization_msgs::Marker& surface,
                    const visualization_msgs::Marker& text) {
  return hash_of(surface) * 1099511628211u + std::hash<std::string>()(text.text);
}

}  // namespace

visualization_msgs::MarkerArray PlaneMarkers::changes(const std::vector<Plane>& planes,
                                                      const std::vector<PlaneLabel>& labels,
                                                      double stripe_gap_m,
                                                      const std_msgs::Header& header) {
  visualization_msgs::MarkerArray array;
  std::map<std::int64_t, std::size_t> now;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Plane& plane = planes[i];
    visualization_msgs::Marker marker = triangles(header, "planes", plane.id);
    add_surface(plane, stripe_gap_m, plane_colour(plane.id), 0.0, marker);
    if (marker.points.empty()) continue;  // rviz complains about a marker without points
    visualization_msgs::Marker text = text_marker(plane, labels.at(i), header);
    const std::size_t hash = now[plane.id] = hash_of(marker, text);
    const auto sent = sent_.find(plane.id);
    if (sent != sent_.end() && sent->second == hash) continue;
    array.markers.push_back(std::move(marker));
    array.markers.push_back(std::move(text));
  }
  for (const auto& [id, hash] : sent_) {
    if (now.count(id) != 0) continue;
    for (const char* ns : {"planes", "labels"}) {
      array.markers.push_back(triangles(header, ns, id));
      array.markers.back().action = visualization_msgs::Marker::DELETE;
    }
  }
  sent_ = std::move(now);
  return array;
}

visualization_msgs::MarkerArray white_markers(const std::vector<Plane>& planes, double stripe_gap_m,
                                              const std_msgs::Header& header) {
  visualization_msgs::Marker marker = triangles(header, "before_correction", 0);
  for (const Plane& plane : planes)
    add_surface(plane, stripe_gap_m, {255, 255, 255}, kWhiteBehind_m, marker);
  // rviz takes the transparency of the marker, other viewers that of each triangle.
  for (std_msgs::ColorRGBA& colour : marker.colors) colour.a = kWhiteAlpha;
  marker.color.a = kWhiteAlpha;
  if (marker.points.empty()) marker.action = visualization_msgs::Marker::DELETE;
  visualization_msgs::MarkerArray array;
  array.markers.push_back(std::move(marker));
  return array;
}

}  // namespace ribbon_mapper
