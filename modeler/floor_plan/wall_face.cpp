// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/floor_plan/wall_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "modeler/polygon/polygon_operations.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kCut_m = 1.0;          // above the floor
constexpr double kLeastLevel = 0.5;     // of a normal's level part: walls lean by up to 30 degrees
constexpr double kTongue_m = 0.2;       // height of stray cells at the end of a wall
constexpr double kSolidShare = 0.5;     // of the band, in one piece: a jamb, not stray cells at it
constexpr double kOpenFrom_m = 0.55;    // least width of a gap, as LabelConfig::least_door_width_m
constexpr double kStripBegin_m = 0.02;  // of the floor behind a face; a floor that ends at a wall
constexpr double kStripEnd_m = 0.1;     // reaches into it by half a cell

bool is_floor(Label label, const Plane& plane) {
  return label == Label::floor || (label == Label::slope && plane.normal.z() > 0.0);
}

Polygons stretched(Polygons polygons, double factor) {
  const auto stretch = [&](Ring& ring) {
    for (Eigen::Vector2d& point : ring) point.x() *= factor;
  };
  for (Polygon& polygon : polygons) {
    stretch(polygon.outer);
    std::for_each(polygon.holes.begin(), polygon.holes.end(), stretch);
  }
  return polygons;
}

/// Returns an elevation without what is low: stray cells beside a wall. Stretched along the wall,
/// it loses and regains a margin above and below, but none at its ends.
Polygons without_tongues(const Polygons& elevation, double height_m) {
  constexpr double kStretch = 1000.0;
  if (elevation.empty()) return elevation;
  Polygons core = grown(stretched(elevation, kStretch), -0.5 * height_m);
  if (core.empty()) return core;
  return stretched(grown(core, 0.5 * height_m), 1.0 / kStretch);
}

/// Returns the outlines of a wall as polygons of position along the face and height.
Polygons elevation_of(const Plane& plane, const WallFace& face) {
  const auto on_face = [&](const std::vector<Eigen::Vector3d>& points) {
    Ring ring;
    for (const Eigen::Vector3d& p : points) ring.emplace_back(face.along_m(p.head<2>()), p.z());
    return ring;
  };
  Polygons polygons;
  for (const Outline& outline : plane.outlines) {
    Polygon& polygon = polygons.emplace_back(Polygon{on_face(outline.outer), {}});
    for (const auto& hole : outline.holes) polygon.holes.push_back(on_face(hole));
  }
  return polygons;
}

Intervals shadow_of(const Polygons& elevation) {
  Intervals intervals;
  for (const Polygon& polygon : elevation) {
    const auto [low, high] = std::minmax_element(
        polygon.outer.begin(), polygon.outer.end(),
        [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() < b.x(); });
    intervals.push_back({low->x(), high->x()});
  }
  return united(std::move(intervals));
}

Polygons rectangle(const Interval& x, const Interval& y) {
  return {{{{x.begin, y.begin}, {x.end, y.begin}, {x.end, y.end}, {x.begin, y.end}}, {}}};
}

/// Returns what was seen of a face in the band.
Polygons in_band(const Polygons& elevation, const Intervals& seen, double floor_m,
                 const FloorPlanConfig& config) {
  if (seen.empty()) return {};
  const Interval band{floor_m + config.band_begin_m, floor_m + config.band_end_m};
  return intersection(elevation, rectangle({seen.front().begin, seen.back().end}, band));
}

/// Returns the share of the strip behind a piece of a face that is floor.
double floor_behind(const WallFace& face, const Interval& piece, const Polygons& floor) {
  const auto at = [&](double along_m, double depth_m) -> Eigen::Vector2d {
    return face.at(along_m) - depth_m * face.normal;
  };
  const Polygons strip{{{at(piece.begin, kStripBegin_m), at(piece.begin, kStripEnd_m),
                         at(piece.end, kStripEnd_m), at(piece.end, kStripBegin_m)},
                        {}}};
  return area(intersection(strip, floor)) / area(strip);
}

std::optional<WallFace> face_of(const Plane& plane, double floor_m, const Polygons& floor,
                                const FloorPlanConfig& config) {
  const double level = plane.normal.head<2>().norm();
  if (level < kLeastLevel || plane.outlines.empty()) return std::nullopt;
  WallFace face;
  face.plane = plane.id;
  face.normal = plane.normal.head<2>() / level;
  face.distance_m = -(plane.d_m + plane.normal.z() * (floor_m + kCut_m)) / level;
  face.cell_m = plane.cell_size_m;
  const Polygons elevation = without_tongues(elevation_of(plane, face), kTongue_m);
  face.seen = shadow_of(elevation);
  const Polygons band = in_band(elevation, face.seen, floor_m, config);
  face.solid =
      shadow_of(without_tongues(band, kSolidShare * (config.band_end_m - config.band_begin_m)));
  for (const Interval& piece : difference(face.seen, shadow_of(band))) {
    if (piece.length() < kOpenFrom_m) continue;
    if (floor_behind(face, piece, floor) >= config.through_share) face.open.push_back(piece);
  }
  face.seen = difference(face.seen, face.open);
  return face;
}

}  // namespace

Polygons floor_of(const std::vector<Plane>& planes, const Semantics& semantics) {
  Polygons floor;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (!is_floor(semantics.labels[i].label, planes[i])) continue;
    for (const Outline& outline : planes[i].outlines) {
      Polygon& polygon = floor.emplace_back();
      for (const Eigen::Vector3d& p : outline.outer) polygon.outer.push_back(p.head<2>());
      for (const auto& hole : outline.holes) {
        Ring& ring = polygon.holes.emplace_back();
        for (const Eigen::Vector3d& p : hole) ring.push_back(p.head<2>());
      }
    }
  }
  return floor.empty() ? floor : grown(floor, 0.0);
}

double floor_height_m(const std::vector<Plane>& planes, const Semantics& semantics) {
  double largest_m2 = 0.0, height_m = 0.0;
  double foot_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Label label = semantics.labels[i].label;
    if (label == Label::floor && planes[i].area_m2 > largest_m2) {
      largest_m2 = planes[i].area_m2;
      height_m = planes[i].centroid.z();
    }
    if (label != Label::wall) continue;
    for (const Outline& outline : planes[i].outlines) {
      for (const Eigen::Vector3d& p : outline.outer) foot_m = std::min(foot_m, p.z());
    }
  }
  return largest_m2 > 0.0 || std::isinf(foot_m) ? height_m : foot_m;
}

std::vector<WallFace> wall_faces(const std::vector<Plane>& planes, const Semantics& semantics,
                                 const Polygons& floor, const FloorPlanConfig& config) {
  const double floor_m = floor_height_m(planes, semantics);
  std::vector<WallFace> faces;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (semantics.labels[i].label != Label::wall) continue;
    if (auto face = face_of(planes[i], floor_m, floor, config)) faces.push_back(std::move(*face));
  }
  return faces;
}

}  // namespace ribbon_mapper
