// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/planes/judge.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "modeler/geometry/moments.hpp"

namespace ribbon_mapper::bench {
namespace {

Moments moments_of(const Points& points) {
  Moments moments;
  for (const Eigen::Vector3f& point : points) moments.add(point.cast<double>());
  return moments;
}

/// A plane of one sweep, grown by others.
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

}  // namespace

std::vector<eval::Patch> patches_of(const std::vector<Points>& planes, const ViewField& views,
                                    double least_area_m2) {
  std::vector<eval::Patch> patches;
  for (const Points& points : planes) {
    if (points.size() < 3) continue;
    const PlaneFit fit = fit_plane(moments_of(points));
    eval::Patch patch{fit.normal(), 0.0, 0.0, {}};
    double side = 0.0;
    for (const Eigen::Vector3f& point : points) {
      side += patch.normal.dot(views.towards_sensor(point).cast<double>());
    }
    if (side < 0.0) patch.normal *= -1.0;
    patch.d_m = -patch.normal.dot(fit.mean);
    for (const Eigen::Vector3f& point : points) patch.cells.push_back(point.cast<double>());
    Plane cells = eval::plane_of(patch, 0);
    cells.area_m2 = cells.cells.size() * cells.cell_size_m * cells.cell_size_m;
    if (cells.area_m2 >= least_area_m2) patches.push_back(eval::patch_of(cells));
  }
  return patches;
}

std::vector<Points> united(const std::vector<Points>& planes) {
  std::vector<Merged> all;
  for (const Points& points : planes) {
    Merged plane = merged_of(points);
    // What it joins may now join others.
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

std::string text_of(const nlohmann::json& m) {
  char text[128];
  std::snprintf(text, sizeof text, "F1 %.3f, missed %d, extra %d, doubled %d, %.2f deg, %.1f mm",
                m["f1"].get<double>(), m["missed"].get<int>(), m["extra"].get<int>(),
                m["duplicates"].get<int>(), m["angle_error_deg"].get<double>(),
                m["offset_error_mm"].get<double>());
  return text;
}

}  // namespace ribbon_mapper::bench
