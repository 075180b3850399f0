// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/corner_lines.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <optional>
#include <utility>

#include "modeler/polygon/polygon_operations.hpp"
#include "modeler/surface/outline.hpp"

namespace ribbon_mapper {
namespace {

using Eigen::Vector3d;
constexpr double kLeastSine = 0.5;  // of the angle between planes with a line in common

/// A plane, and where it was seen.
struct Seen {
  const Plane* plane;
  Polygons area;            // along the plane's axes
  Eigen::AlignedBox3d box;  // of the outlines
};

Seen seen(const Plane& plane) {
  Seen result{&plane, areas_of(plane), {}};
  for (const Outline& outline : plane.outlines) {
    for (const Vector3d& corner : outline.outer) result.box.extend(corner);
  }
  return result;
}

/// Moves the corners of one plane.
class CornerJoiner {
 public:
  CornerJoiner(const Seen& own, const std::vector<Seen>& all, double reach_m)
      : plane_(*own.plane), reach_m_(reach_m) {
    for (const Seen& other : all) {
      const double sine = plane_.normal.cross(other.plane->normal).norm();
      if (sine < kLeastSine) continue;
      if (own.box.squaredExteriorDistance(other.box) <= 4.0 * reach_m * reach_m) {
        neighbours_.push_back(&other);
      }
    }
  }

  /// Returns the outlines with moved corners, each as it was if it would overlap itself.
  std::vector<Outline> joined() const {
    std::vector<Outline> outlines;
    for (const Outline& outline : plane_.outlines) {
      Outline moved{joined(outline.outer), {}};
      for (const auto& hole : outline.holes) moved.holes.push_back(joined(hole));
      if (!is_valid(area_of(plane_, moved))) moved = outline;
      outlines.push_back(std::move(moved));
    }
    return outlines;
  }

 private:
  std::vector<Vector3d> joined(const std::vector<Vector3d>& ring) const {
    std::vector<Vector3d> moved;
    for (const Vector3d& corner : ring) {
      const Vector3d place = joined(corner);
      if (moved.empty() || place != moved.back()) moved.push_back(place);
    }
    while (moved.size() > 1 && moved.back() == moved.front()) moved.pop_back();
    return moved;
  }

  Vector3d joined(const Vector3d& corner) const {
    std::vector<std::pair<double, const Plane*>> lines;
    for (const Seen* other : neighbours_) {
      const Vector3d place = on_line(corner, *other->plane);
      const double distance_m = (place - corner).norm();
      if (distance_m > reach_m_ || !was_seen_near(*other, place)) continue;
      lines.emplace_back(distance_m, other->plane);
    }
    if (lines.empty()) return corner;
    std::stable_sort(lines.begin(), lines.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 1; i < lines.size(); ++i) {
      if (const auto point = meeting(*lines[0].second, *lines[i].second)) {
        if ((*point - corner).norm() <= 2.0 * reach_m_) return *point;
      }
    }
    return on_line(corner, *lines[0].second);
  }

  /// Returns the point nearest to the corner where the plane intersects another one.
  Vector3d on_line(const Vector3d& corner, const Plane& other) const {
    const Vector3d across = other.normal - other.normal.dot(plane_.normal) * plane_.normal;
    const double distance_m = other.normal.dot(corner) + other.d_m;
    return corner - distance_m / across.squaredNorm() * across;
  }

  /// Returns where the plane meets two others, unless their lines are almost parallel.
  std::optional<Vector3d> meeting(const Plane& a, const Plane& b) const {
    Eigen::Matrix3d normals;
    normals << plane_.normal.transpose(), a.normal.transpose(), b.normal.transpose();
    if (std::abs(normals.determinant()) < kLeastSine * kLeastSine) return std::nullopt;
    return normals.inverse() * -Vector3d(plane_.d_m, a.d_m, b.d_m);
  }

  bool was_seen_near(const Seen& other, const Vector3d& point) const {
    const Eigen::AlignedBox3d& box = other.box;
    if (box.squaredExteriorDistance(point) > reach_m_ * reach_m_) return false;
    return distance(other.area, on_axes(*other.plane, point)) <= reach_m_;
  }

  const Plane& plane_;
  double reach_m_;
  std::vector<const Seen*> neighbours_;
};

}  // namespace

void join_at_corner_lines(std::vector<Plane>& planes, double reach_m) {
  std::vector<Seen> all;
  for (const Plane& plane : planes) all.push_back(seen(plane));
  std::vector<std::vector<Outline>> joined;
  for (const Seen& own : all) joined.push_back(CornerJoiner(own, all, reach_m).joined());
  for (std::size_t i = 0; i < planes.size(); ++i) planes[i].outlines = std::move(joined[i]);
}

}  // namespace ribbon_mapper
