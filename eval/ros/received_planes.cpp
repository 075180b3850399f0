// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/ros/received_planes.hpp"

#include <cmath>

namespace ribbon_mapper::eval {
namespace {

template <typename Message>
Eigen::Vector3d vector_of(const Message& message) {
  return {message.x, message.y, message.z};
}

/// Sets the cells, on a grid whose cell (0, 0) is the first one sent.
void set_cells(const BoundedPlane& message, Plane& plane) {
  if (message.cells.empty()) return;
  const double size_m = plane.cell_size_m;
  const Eigen::Vector3d first = vector_of(message.cells.front());
  plane.origin = first - 0.5 * size_m * (plane.axis_u + plane.axis_v);
  for (const geometry_msgs::Point32& centre : message.cells) {
    const Eigen::Vector3d offset = vector_of(centre) - first;
    const auto index = [&](const Eigen::Vector3d& axis) {
      return static_cast<std::int32_t>(std::lround(offset.dot(axis) / size_m));
    };
    plane.cells.push_back({index(plane.axis_u), index(plane.axis_v), 1, 0.0F, 0.0F});
  }
}

std::vector<Eigen::Vector3d> ring_of(const geometry_msgs::Polygon& polygon) {
  std::vector<Eigen::Vector3d> ring;
  for (const auto& corner : polygon.points) ring.push_back(vector_of(corner));
  return ring;
}

Plane plane_from(const BoundedPlane& message) {
  Plane plane;
  plane.id = message.id;
  plane.normal = vector_of(message.normal);
  plane.d_m = message.d;
  plane.area_m2 = message.area;
  plane.centroid = vector_of(message.centroid);
  for (int i = 0; i < 9; ++i) plane.covariance(i / 3, i % 3) = message.covariance[i];
  plane.cell_size_m = message.cell_size;
  plane.axis_u = vector_of(message.axis_u);
  plane.axis_v = vector_of(message.axis_v);
  for (const auto& outline : message.outlines) {
    plane.outlines.push_back({ring_of(outline.outer), {}});
    for (const auto& hole : outline.holes) plane.outlines.back().holes.push_back(ring_of(hole));
  }
  set_cells(message, plane);
  return plane;
}

}  // namespace

std::vector<Plane> planes_from(const PlaneArray& message) {
  std::vector<Plane> planes;
  for (const BoundedPlane& plane : message.planes) planes.push_back(plane_from(plane));
  return planes;
}

std::vector<PlaneLabel> labels_from(const PlaneArray& message) {
  std::vector<PlaneLabel> labels;
  for (const BoundedPlane& plane : message.planes) {
    labels.push_back({plane.label, plane.label_confidence, plane.note,
                      label_from(plane.label).value_or(Label::furniture)});
  }
  return labels;
}

std::vector<Patch> patches_from(const PlaneArray& message) {
  std::vector<Patch> patches;
  for (const BoundedPlane& plane : message.planes) {
    patches.push_back({vector_of(plane.normal), plane.d, plane.area, vector_of(plane.axis_u), {}});
    for (const auto& cell : plane.cells) patches.back().cells.push_back(vector_of(cell));
  }
  return patches;
}

}  // namespace ribbon_mapper::eval
