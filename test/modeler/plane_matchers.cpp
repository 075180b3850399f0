// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "test/modeler/plane_matchers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ribbon_mapper::mini_world {
namespace {

template <typename Value>
void append(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void append(std::string& bytes, const Eigen::Vector3d& v) {
  for (int i = 0; i < 3; ++i) append(bytes, v[i]);
}

void append(std::string& bytes, const Outline& outline) {
  for (const Eigen::Vector3d& corner : outline.outer) append(bytes, corner);
  for (const auto& hole : outline.holes) {
    append(bytes, hole.size());
    for (const Eigen::Vector3d& corner : hole) append(bytes, corner);
  }
}

bool is_at(const Face& face, const Plane& plane, double angle_deg, double distance_m) {
  const double cosine = face.normal.dot(plane.normal);
  return cosine > std::cos(angle_deg * M_PI / 180.0) &&
         std::abs(face.normal.dot(plane.centroid) + face.d_m) < distance_m;
}

}  // namespace

std::string bytes_of(const std::vector<Plane>& planes) {
  std::string bytes;
  for (const Plane& p : planes) {
    append(bytes, p.id), append(bytes, p.d_m), append(bytes, p.area_m2);
    append(bytes, p.ribbons.size()), append(bytes, p.cell_size_m);
    for (const auto& v : {p.normal, p.centroid, p.origin, p.axis_u, p.axis_v}) append(bytes, v);
    for (int i = 0; i < 3; ++i) append(bytes, Eigen::Vector3d(p.covariance.col(i)));
    for (const PlaneCell& cell : p.cells) {
      append(bytes, cell.u), append(bytes, cell.v), append(bytes, cell.count);
      append(bytes, cell.mean_m), append(bytes, cell.variance_m2);
    }
    for (const Outline& outline : p.outlines) append(bytes, outline);
  }
  return bytes;
}

void expect_same(const std::vector<Plane>& expected, const std::vector<Plane>& actual,
                 double tolerance) {
  ASSERT_EQ(expected.size(), actual.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Plane &e = expected[i], &a = actual[i];
    SCOPED_TRACE("plane " + std::to_string(i));
    EXPECT_EQ(e.id, a.id);
    EXPECT_EQ(e.ribbons.size(), a.ribbons.size());
    EXPECT_EQ(e.cell_size_m, a.cell_size_m);
    EXPECT_LT((e.normal - a.normal).norm(), tolerance);
    EXPECT_NEAR(e.d_m, a.d_m, tolerance);
    // A point in a thousand may lie on the border of a cell.
    const double border_m2 = 1e-3 * e.area_m2 + e.cell_size_m * e.cell_size_m;
    EXPECT_NEAR(e.area_m2, a.area_m2, border_m2);
    EXPECT_LT((e.centroid - a.centroid).norm(), tolerance + 1e-3);
    EXPECT_LT((e.origin - a.origin).norm(), tolerance);
    EXPECT_LT((e.axis_u - a.axis_u).norm(), tolerance);
    EXPECT_LT((e.axis_v - a.axis_v).norm(), tolerance);
    EXPECT_LT((e.covariance - a.covariance).norm(), tolerance);
  }
}

std::vector<Plane> anonymous(std::vector<Plane> planes) {
  const auto key = [](const Plane& p) {
    return 100.0 * p.normal.dot(Eigen::Vector3d(1.0, 2.3, 5.1)) + p.d_m;
  };
  std::sort(planes.begin(), planes.end(),
            [&](const Plane& a, const Plane& b) { return key(a) < key(b); });
  for (Plane& plane : planes) plane.id = 0;
  return planes;
}

Plane moved(Plane plane, const Pose& T) {
  for (Eigen::Vector3d* axis : {&plane.normal, &plane.axis_u, &plane.axis_v}) {
    *axis = T.linear() * *axis;
  }
  for (Eigen::Vector3d* point : {&plane.origin, &plane.centroid}) *point = T * *point;
  for (Outline& outline : plane.outlines) {
    for (Eigen::Vector3d& corner : outline.outer) corner = T * corner;
    for (auto& hole : outline.holes) {
      for (Eigen::Vector3d& corner : hole) corner = T * corner;
    }
  }
  plane.d_m = -plane.normal.dot(plane.centroid);
  return plane;
}

void expect_one_for_each(const World& world, const std::vector<Plane>& planes, double angle_deg,
                         double distance_m) {
  EXPECT_EQ(world.size(), planes.size());
  for (const Face& face : world) {
    EXPECT_EQ(1, std::count_if(planes.begin(), planes.end(),
                               [&](const Plane& plane_) {
                                 return is_at(face, plane_, angle_deg, distance_m);
                               }))
        << "planes at the face with normal " << face.normal.transpose() << ", d " << face.d_m;
  }
}

}  // namespace ribbon_mapper::mini_world
