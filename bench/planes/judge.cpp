// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/planes/judge.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "bench/stopwatch.hpp"
#include "modeler/assembly/model_quality.hpp"
#include "modeler/geometry/plane_fit.hpp"
#include "modeler/surface/footprint.hpp"

namespace ribbon_mapper::bench {
namespace {

Moments moments_of(const Points& points) {
  Moments moments;
  for (const Eigen::Vector3f& point : points) moments.add(point.cast<double>());
  return moments;
}

/// A plane of one sweep, merged with those of others.
struct Merged {
  Moments moments;
  PlaneFit fit;
  Eigen::AlignedBox3f box;
  Points points;

  bool is_same(const Merged& other) const {
    constexpr double kAngle = 0.9962, kOffset_m = 0.05;  // 5 degrees
    constexpr float kGap_m = 0.5F;
    return std::abs(fit.normal().dot(other.fit.normal())) > kAngle &&
           std::abs(fit.normal().dot(other.fit.mean - fit.mean)) < kOffset_m &&
           box.exteriorDistance(other.box) < kGap_m;
  }
  void take(const Merged& other) {
    moments += other.moments;
    fit = fit_plane(moments);
    box.extend(other.box);
    points.insert(points.end(), other.points.begin(), other.points.end());
  }
};

Merged merged_of(const Points& points) {
  Merged plane{moments_of(points), {}, {}, points};
  plane.fit = fit_plane(plane.moments);
  for (const Eigen::Vector3f& point : points) plane.box.extend(point);
  return plane;
}

/// Returns the distance of a point from the nearest plane that it lies on, if any.
std::optional<double> distance_of(const Eigen::Vector3d& point,
                                  const std::vector<Footprint>& footprints) {
  constexpr double kMax_m = 0.10;
  std::optional<double> nearest_m;
  for (const Footprint& footprint : footprints) {
    if (!footprint.holds(point, kMax_m)) continue;
    const Plane& plane = footprint.plane();
    const double distance_m = std::abs(plane.normal.dot(point) + plane.d_m);
    if (!nearest_m || distance_m < *nearest_m) nearest_m = distance_m;
  }
  return nearest_m;
}

}  // namespace

std::vector<Plane> bounded_planes(const std::vector<Points>& planes, const ViewField& views,
                                  const ModelerConfig& config) {
  std::vector<Plane> bounded;
  for (const Points& points : planes) {
    if (points.size() < 3) continue;
    const PlaneFit fit = fit_plane(moments_of(points));
    eval::Patch patch;
    patch.normal = fit.normal();
    double side = 0.0;
    for (const Eigen::Vector3f& point : points) {
      side += patch.normal.dot(views.towards_sensor(point).cast<double>());
    }
    if (side < 0.0) patch.normal *= -1.0;
    patch.d_m = -patch.normal.dot(fit.mean);
    for (const Eigen::Vector3f& point : points) patch.cells.push_back(point.cast<double>());
    Plane plane = eval::plane_of(patch, 0, config.surface.cell_size_m);
    plane.area_m2 = plane.cells.size() * plane.cell_size_m * plane.cell_size_m;
    if (plane.area_m2 >= config.assembly.min_area_m2) bounded.push_back(std::move(plane));
  }
  return bounded;
}

std::vector<Points> united(const std::vector<Points>& planes) {
  std::vector<Merged> all;
  for (const Points& points : planes) {
    Merged plane = merged_of(points);
    // A merged plane may match further planes, so the search starts again.
    for (auto it = all.begin(); it != all.end();) {
      if (!plane.is_same(*it)) {
        ++it;
        continue;
      }
      plane.take(*it);
      all.erase(it);
      it = all.begin();
    }
    all.push_back(std::move(plane));
  }
  std::vector<Points> result;
  for (Merged& plane : all) result.push_back(std::move(plane.points));
  return result;
}

nlohmann::json to_json(const eval::MapMetrics& metrics) {
  return {{"f1", metrics.f1},
          {"planes", metrics.planes},
          {"truth", metrics.truth},
          {"matched", metrics.matched},
          {"missed", metrics.missed.size()},
          {"extra", metrics.extra.size()},
          {"duplicates", metrics.duplicates.size()},
          {"coverage", metrics.coverage},
          {"angle_error_deg", metrics.angle_error_deg_mean.value_or(0.0)},
          {"offset_error_mm", 1e3 * metrics.offset_error_m_mean.value_or(0.0)}};
}

nlohmann::json judged_by_points(const std::vector<Plane>& planes, const Points& points,
                                const ModelerConfig& config) {
  std::vector<Footprint> footprints;
  double area_m2 = 0.0;
  for (const Plane& plane : planes) {
    footprints.emplace_back(plane, config.surface.cell_size_m);
    area_m2 += plane.area_m2;
  }
  const std::size_t stride = 1 + points.size() / 200'000;  // a sample suffices
  std::vector<double> distances_m;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    if (const auto distance_m = distance_of(points[i].cast<double>(), footprints)) {
      distances_m.push_back(*distance_m);
    }
  }
  DuplicateRule rule;
  rule.touching_m = config.surface.stripe_gap_m;
  return {{"planes", planes.size()},
          {"area_m2", area_m2},
          {"duplicates", duplicates_of_larger(planes, rule).size()},
          {"points_share",
           static_cast<double>(distances_m.size() * stride) / static_cast<double>(points.size())},
          {"points_mm", distances_m.empty() ? 0.0 : 1e3 * median(distances_m)}};
}

std::string text_of(const nlohmann::json& m) {
  char text[128];
  if (m.contains("f1")) {
    std::snprintf(text, sizeof text,
                  "F1 %.3f, missed %d, extra %d, duplicates %d, %.2f deg, %.1f mm",
                  m["f1"].get<double>(), m["missed"].get<int>(), m["extra"].get<int>(),
                  m["duplicates"].get<int>(), m["angle_error_deg"].get<double>(),
                  m["offset_error_mm"].get<double>());
  } else {
    std::snprintf(
        text, sizeof text,
        "%d planes, %.1f m2, duplicates %d; %.0f %% of points on planes, median distance %.1f mm",
        m["planes"].get<int>(), m["area_m2"].get<double>(), m["duplicates"].get<int>(),
        100.0 * m["points_share"].get<double>(), m["points_mm"].get<double>());
  }
  return text;
}

}  // namespace ribbon_mapper::bench
