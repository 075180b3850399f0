// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/messages/plane_markers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>

#include "modeler/ros/messages/marker.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/messages/plane_edges.hpp"
#include "modeler/ros/messages/text_places.hpp"

namespace ribbon_mapper {
namespace {

using visualization_msgs::Marker;

/// White planes lie this far behind coloured ones, so that they show only where the model has
/// moved.
constexpr double kWhiteBehind_m = 0.02;
/// White planes are pale, so that coloured ones show through them, as in figure 8 of the paper.
constexpr float kWhiteAlpha = 0.35F;

/// Height of a capital letter: 11 pixels in a view of a flat.
constexpr double kLetter_m = 0.2;
/// Texts face the viewer, and stand this far before their planes, so that these hide no half of
/// them.
constexpr double kTextBefore_m = 0.35;
constexpr double kNormal_m = 0.3;
constexpr double kOutline_m = 0.015, kEdge_m = 0.03;  // widths of lines
constexpr double kLineBefore_m = 0.005;               // lines before their planes
constexpr double kLineShade = 0.45;                   // lines are darker than their planes
constexpr Colour kEdgeColour{238, 240, 244};
constexpr Colour kFloorColour{150, 154, 160}, kCeilingColour{196, 200, 206};
/// Surfaces that fill a screen are calmer than thin lines on paper, by this share of a light grey.
constexpr double kCalm = 0.35;
constexpr double kLightGrey = 200.0;

std::uint8_t calmed(std::uint8_t channel) {
  return static_cast<std::uint8_t>(std::lround((1.0 - kCalm) * channel + kCalm * kLightGrey));
}

/// Adds the surface of a plane to a marker, drawn `behind_m` behind its front.
void add_surface(const Plane& plane, double stripe_gap_m, const Colour& colour, double behind_m,
                 Marker& marker) {
  const std_msgs::ColorRGBA shade = shaded(colour, plane.normal);
  const Eigen::Vector3d shift = -behind_m * plane.normal;
  const auto corner = [&](int u, int v) { return point_message(grid_corner(plane, u, v) + shift); };
  for (const CellRectangle& r : surface_rectangles(plane, stripe_gap_m)) {
    const geometry_msgs::Point a = corner(r.u_begin, r.v_begin), b = corner(r.u_end, r.v_begin);
    const geometry_msgs::Point c = corner(r.u_end, r.v_end), d = corner(r.u_begin, r.v_end);
    marker.points.insert(marker.points.end(), {a, b, c, a, c, d});
    marker.colors.insert(marker.colors.end(), 2, shade);
  }
}

/// Returns id and label, and the area below.
std::string text_of(const Plane& plane, const PlaneLabel& label) {
  std::array<char, 200> text;
  std::snprintf(text.data(), text.size(), "%lld %s\n%.1f m2", static_cast<long long>(plane.id),
                label.text.c_str(), plane.area_m2);
  return text.data();
}

/// Makes the markers of one plane.
class MarkersOfPlane {
 public:
  MarkersOfPlane(const Plane& plane, const PlaneLabel& label, const std_msgs::Header& header)
      : plane_(plane),
        label_(label),
        header_(header),
        is_ceiling_(label.rule == Label::ceiling),
        colour_(shown_colour(plane, label.rule)) {}

  Marker surface(double stripe_gap_m) const {
    Marker marker = begin(Marker::TRIANGLE_LIST, is_ceiling_ ? "ceilings" : "planes");
    add_surface(plane_, stripe_gap_m, colour_, 0.0, marker);
    return marker;
  }

  Marker text(TextPlaces& places) const {
    Marker marker = begin(Marker::TEXT_VIEW_FACING, is_ceiling_ ? "ceiling labels" : "labels");
    marker.text = text_of(plane_, label_);
    marker.pose.position =
        point_message(places.take(plane_.centroid + kTextBefore_m * plane_.normal, marker.text));
    marker.scale.z = kLetter_m;
    marker.color = colour_message({255, 255, 255});
    return marker;
  }

  Marker outlines() const {
    Marker marker = begin(Marker::LINE_LIST, "outlines");
    add_sides(plane_.outlines, kLineBefore_m * plane_.normal, marker);
    marker.scale.x = kOutline_m;
    marker.color = colour_message(colour_, kLineShade);
    return marker;
  }

  Marker normal() const {
    Marker marker = begin(Marker::ARROW, "normals");
    add_line(plane_.centroid, plane_.centroid + kNormal_m * plane_.normal, marker);
    marker.scale.x = 0.1 * kNormal_m;  // of the shaft
    marker.scale.y = 0.2 * kNormal_m;  // of the head
    marker.scale.z = 0.3 * kNormal_m;  // its length
    marker.color = colour_message(colour_, kLineShade);
    return marker;
  }

 private:
  Marker begin(std::int32_t type, const char* ns) const {
    return new_marker(type, header_, ns, plane_.id);
  }

  const Plane& plane_;
  const PlaneLabel& label_;
  const std_msgs::Header& header_;
  bool is_ceiling_;
  Colour colour_;
};

Marker edges_marker(const std::vector<Plane>& planes, const std_msgs::Header& header) {
  Marker marker = new_marker(Marker::LINE_LIST, header, "edges", 0);
  for (const Edge& edge : edges_of(planes)) add_line(edge[0], edge[1], marker);
  marker.scale.x = kEdge_m;
  marker.color = colour_message(kEdgeColour);
  return marker;
}

/// Returns the indices of planes, the smallest first: a text can move far on a large plane.
std::vector<std::size_t> by_area(const std::vector<Plane>& planes) {
  std::vector<std::size_t> order(planes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return planes[a].area_m2 < planes[b].area_m2;
  });
  return order;
}

/// Returns all markers of the planes. rviz complains about a marker without points: there is none.
std::vector<Marker> markers_of(const std::vector<Plane>& planes,
                               const std::vector<PlaneLabel>& labels, double stripe_gap_m,
                               const std_msgs::Header& header) {
  std::vector<Marker> markers;
  TextPlaces places(kLetter_m);
  for (const std::size_t i : by_area(planes)) {
    const MarkersOfPlane of_plane(planes[i], labels.at(i), header);
    Marker surface = of_plane.surface(stripe_gap_m);
    if (surface.points.empty()) continue;
    markers.push_back(std::move(surface));
    markers.push_back(of_plane.text(places));
    markers.push_back(of_plane.normal());
    Marker outlines = of_plane.outlines();
    if (!outlines.points.empty()) markers.push_back(std::move(outlines));
  }
  Marker edges = edges_marker(planes, header);
  if (!edges.points.empty()) markers.push_back(std::move(edges));
  return markers;
}

void combine(std::size_t& hash, std::size_t with) { hash = hash * 1099511628211u + with; }

void combine(std::size_t& hash, const geometry_msgs::Point& point) {
  for (const double value : {point.x, point.y, point.z}) {
    combine(hash, std::hash<double>()(value));
  }
}

std::size_t hash_of(const Marker& marker) {
  std::size_t hash = marker.points.size();
  for (const geometry_msgs::Point& point : marker.points) combine(hash, point);
  combine(hash, marker.pose.position);
  combine(hash, std::hash<std::string>()(marker.text));
  // A plane changes its colour with its label.
  const std_msgs::ColorRGBA& colour = marker.colors.empty() ? marker.color : marker.colors.front();
  for (const float value : {colour.r, colour.g, colour.b}) {
    combine(hash, std::hash<float>()(value));
  }
  return hash;
}

}  // namespace

Colour shown_colour(const Plane& plane, Label rule) {
  if (rule == Label::floor) return kFloorColour;
  if (rule == Label::ceiling) return kCeilingColour;
  const Colour colour = plane_colour(plane.id);
  return {calmed(colour.red), calmed(colour.green), calmed(colour.blue)};
}

visualization_msgs::MarkerArray PlaneMarkers::changes(const std::vector<Plane>& planes,
                                                      const std::vector<PlaneLabel>& labels,
                                                      double stripe_gap_m,
                                                      const std_msgs::Header& header) {
  visualization_msgs::MarkerArray array;
  std::map<Key, std::size_t> now;
  for (Marker& marker : markers_of(planes, labels, stripe_gap_m, header)) {
    const Key key(marker.ns, marker.id);
    const std::size_t hash = now[key] = hash_of(marker);
    const auto sent = sent_.find(key);
    if (sent == sent_.end() || sent->second != hash) array.markers.push_back(std::move(marker));
  }
  for (const auto& [key, hash] : sent_) {
    if (now.count(key) != 0) continue;
    array.markers.push_back(new_marker(Marker::CUBE, header, key.first, key.second));
    array.markers.back().action = Marker::DELETE;
  }
  sent_ = std::move(now);
  return array;
}

visualization_msgs::MarkerArray white_markers(const std::vector<Plane>& planes, double stripe_gap_m,
                                              const std_msgs::Header& header) {
  Marker marker = new_marker(Marker::TRIANGLE_LIST, header, "before_correction", 0);
  for (const Plane& plane : planes)
    add_surface(plane, stripe_gap_m, {255, 255, 255}, kWhiteBehind_m, marker);
  // rviz takes the transparency of the marker, other viewers that of each triangle.
  for (std_msgs::ColorRGBA& colour : marker.colors) colour.a = kWhiteAlpha;
  marker.color.a = kWhiteAlpha;
  if (marker.points.empty()) marker.action = Marker::DELETE;
  visualization_msgs::MarkerArray array;
  array.markers.push_back(std::move(marker));
  return array;
}

}  // namespace ribbon_mapper
