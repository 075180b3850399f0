// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/messages/plane_edges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ribbon_mapper {
namespace {

constexpr double kOnPlane_m = 0.002;  // corners on a line are moved onto it, but for rounding
constexpr double kSeenNear_m = 0.1;   // two cells
constexpr double kLeastSine = 0.5;    // of the angle between planes, as join_at_corner_lines()

using Box = Eigen::AlignedBox3d;

Box box_of(const Plane& plane) {
  Box box;
  for (const Outline& outline : plane.outlines) {
    for (const Eigen::Vector3d& corner : outline.outer) box.extend(corner);
  }
  return box;
}

bool is_on(const Edge& side, const Plane& other, const Box& box) {
  for (const Eigen::Vector3d& end : side) {
    if (std::abs(other.normal.dot(end) + other.d_m) > kOnPlane_m) return false;
  }
  const Eigen::Vector3d middle = 0.5 * (side[0] + side[1]);
  return box.squaredExteriorDistance(middle) <= kSeenNear_m * kSeenNear_m;
}

void add_edges(const Plane& plane, const Plane& other, const Box& box, std::vector<Edge>& edges) {
  const auto add = [&](const std::vector<Eigen::Vector3d>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Edge side{ring[i], ring[(i + 1) % ring.size()]};
      if (is_on(side, other, box)) edges.push_back(side);
    }
  };
  for (const Outline& outline : plane.outlines) {
    add(outline.outer);
    for (const auto& hole : outline.holes) add(hole);
  }
}

}  // namespace

std::vector<Edge> edges_of(const std::vector<Plane>& planes) {
  std::vector<Box> boxes;
  std::vector<std::size_t> order;  // by the beginning of their boxes along x
  for (const Plane& plane : planes) {
    boxes.push_back(box_of(plane));
    if (!boxes.back().isEmpty()) order.push_back(boxes.size() - 1);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return boxes[a].min().x() < boxes[b].min().x();
  });
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Plane& plane = planes[order[i]];
    const Box& box = boxes[order[i]];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const Box& other_box = boxes[order[j]];
      if (other_box.min().x() > box.max().x() + kSeenNear_m) break;
      const Plane& other = planes[order[j]];
      if (plane.normal.cross(other.normal).norm() < kLeastSine) continue;
      if (box.squaredExteriorDistance(other_box) > kSeenNear_m * kSeenNear_m) continue;
      add_edges(plane, other, other_box, edges);
      add_edges(other, plane, box, edges);
    }
  }
  return edges;
}

}  // namespace ribbon_mapper
