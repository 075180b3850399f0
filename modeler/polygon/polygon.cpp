// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/polygon/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ribbon_mapper {

namespace {

/// Returns the squared distance of a point from the line between a and b.
double squared_distance(const Eigen::Vector2d& point, const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0.0 ? along.dot(point - a) / length2 : 0.0;
  return (a + std::clamp(share, 0.0, 1.0) * along - point).squaredNorm();
}

/// Returns true if a line from the point to the right crosses the line between a and b.
bool crosses(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  if ((a.y() > point.y()) == (b.y() > point.y())) return false;
  const double share = (point.y() - a.y()) / (b.y() - a.y());
  return point.x() < a.x() + share * (b.x() - a.x());
}

}  // namespace

double distance(const Polygons& polygons, const Eigen::Vector2d& point) {
  double least2 = std::numeric_limits<double>::infinity();
  bool is_inside = false;
  const auto visit = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d &a = ring[i], &b = ring[(i + 1) % ring.size()];
      least2 = std::min(least2, squared_distance(point, a, b));
      is_inside ^= crosses(point, a, b);
    }
  };
  for (const Polygon& polygon : polygons) {
    visit(polygon.outer);
    for (const Ring& hole : polygon.holes) visit(hole);
  }
  return is_inside ? 0.0 : std::sqrt(least2);
}

double signed_area(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i] - ring.front();
    const Eigen::Vector2d b = ring[(i + 1) % ring.size()] - ring.front();
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return 0.5 * twice;
}

double area(const Polygon& polygon) {
  double sum = std::abs(signed_area(polygon.outer));
  for (const Ring& hole : polygon.holes) sum -= std::abs(signed_area(hole));
  return sum;
}

double area(const Polygons& polygons) {
  double sum = 0.0;
  for (const Polygon& polygon : polygons) sum += area(polygon);
  return sum;
}

}  // namespace ribbon_mapper
