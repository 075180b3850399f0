// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/corner_lines.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <optional>
#include <utility>

#include "modeler/assembly/box_index.hpp"
#include "modeler/polygon/polygon_operations.hpp"
#include "modeler/surface/outline.hpp"

namespace ribbon_mapper {
namespace {

using Eigen::Vector3d;
constexpr double kLeastSine = 0.5;  // of the angle between planes with a line in common

/// Returns true if a way from a over b to c goes back on itself: corners that were moved to one
/// line may change places there.
bool is_spike(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  constexpr double kSine = 1e-6;  // more than rounding leaves
  const Vector3d there = b - a, back = c - b;
  return there.dot(back) < 0.0 && there.cross(back).norm() < kSine * there.norm() * back.norm();
}

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
  CornerJoiner(const Plane& plane, const std::vector<const Seen*>& near, double reach_m)
      : plane_(plane), reach_m_(reach_m) {
    for (const Seen* other : near) {
      const double sine = plane_.normal.cross(other->plane->normal).norm();
      if (sine >= kLeastSine) neighbours_.push_back(other);
    }
  }

  /// Returns the outlines with moved corners: each as it was if it would overlap itself, all as
  /// they were if they would overlap each other.
  std::vector<Outline> joined() const {
    std::vector<Outline> outlines;
    for (const Outline& outline : plane_.outlines) {
      Outline moved{joined(outline.outer), {}};
      for (const auto& hole : outline.holes) moved.holes.push_back(joined(hole));
      if (!is_valid({area_of(plane_, moved)})) moved = outline;
      outlines.push_back(std::move(moved));
    }
    const bool is_whole = outlines.size() < 2 || is_valid(areas_of(plane_, outlines));
    return is_whole ? outlines : plane_.outlines;
  }

 private:
  std::vector<Vector3d> joined(const std::vector<Vector3d>& ring) const {
    std::vector<Vector3d> moved;
    moved.reserve(ring.size());
    for (const Vector3d& corner : ring) moved.push_back(joined(corner));
    const auto is_superfluous = [&](std::size_t i) {
      const Vector3d& before = moved[(i + moved.size() - 1) % moved.size()];
      const Vector3d& after = moved[(i + 1) % moved.size()];
      return moved[i] == before || is_spike(before, moved[i], after);
    };
    // What is left may be superfluous in its turn, a corner before it as well.
    for (std::size_t i = 0, kept = 0; kept < moved.size() && moved.size() > 2;) {
      if (is_superfluous(i)) {
        moved.erase(moved.begin() + static_cast<std::ptrdiff_t>(i));
        i = (i + moved.size() - 1) % moved.size(), kept = 0;
      } else {
        i = (i + 1) % moved.size(), ++kept;
      }
    }
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
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Plane& plane : planes) {
    all.push_back(seen(plane));
    boxes.push_back(all.back().box);
  }
  const BoxIndex index(boxes);
  std::vector<std::vector<Outline>> joined;
  for (const Seen& own : all) {
    std::vector<const Seen*> near;
    for (const std::size_t i : index.near(own.box, 2.0 * reach_m)) near.push_back(&all[i]);
    joined.push_back(CornerJoiner(*own.plane, near, reach_m).joined());
  }
  for (std::size_t i = 0; i < planes.size(); ++i) planes[i].outlines = std::move(joined[i]);
}

}  // namespace ribbon_mapper
