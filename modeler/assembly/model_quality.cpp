// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/model_quality.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/assembly/box_index.hpp"
#include "modeler/geometry/angles.hpp"
#include "modeler/surface/footprint.hpp"

namespace ribbon_mapper {
namespace {

/// Returns true if a cell of the smaller plane lies near the cells of the larger one.
bool touches(const Plane& smaller, const Footprint& larger, double max_offset_m) {
  return std::any_of(smaller.cells.begin(), smaller.cells.end(), [&](const PlaneCell& cell) {
    return larger.holds(cell_centre(smaller, cell), max_offset_m);
  });
}

bool is_duplicate(const Plane& smaller, const Footprint& footprint, const DuplicateRule& rule) {
  const Plane& larger = footprint.plane();
  const double cosine = std::cos(rule.max_angle_deg * kDegree);
  return smaller.normal.dot(larger.normal) > cosine &&
         std::abs(larger.normal.dot(smaller.centroid) + larger.d_m) < rule.max_offset_m &&
         touches(smaller, footprint, rule.max_offset_m);
}

/// Returns the share of a normal distribution within +-`limit`.
double share_within(double limit, double mean, double sigma) {
  if (sigma <= 0.0) return std::abs(mean) <= limit ? 1.0 : 0.0;
  const double scale = 1.0 / (sigma * M_SQRT2);
  return 0.5 * (std::erf((limit - mean) * scale) - std::erf((-limit - mean) * scale));
}

/// Returns the expected number of points within a distance of their planes.
double points_within(double limit_m, const std::vector<Plane>& planes) {
  double points = 0.0;
  for (const Plane& plane : planes) {
    for (const PlaneCell& cell : plane.cells) {
      points += cell.count * share_within(limit_m, cell.mean_m, std::sqrt(cell.variance_m2));
    }
  }
  return points;
}

}  // namespace

std::vector<std::size_t> duplicates_of_larger(const std::vector<Plane>& planes,
                                              const DuplicateRule& rule) {
  std::vector<std::size_t> duplicates;
  std::vector<Footprint> footprints;
  for (const Plane& plane : planes) footprints.emplace_back(plane, rule.touching_m);
  const BoxIndex index(boxes_of_cells(planes));
  const double reach_m = 2.0 * M_SQRT2 * rule.touching_m + rule.max_offset_m;  // of a footprint
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (const std::size_t j : index.near(box_of_cells(planes[i]), reach_m)) {
      const bool j_is_larger = planes[j].area_m2 > planes[i].area_m2 ||
                               (planes[j].area_m2 == planes[i].area_m2 && j < i);
      if (!j_is_larger || !is_duplicate(planes[i], footprints[j], rule)) continue;
      duplicates.push_back(i);
      break;
    }
  }
  return duplicates;
}

std::optional<double> median_residual_m(const std::vector<Plane>& planes) {
  const double half = 0.5 * static_cast<double>(point_count(planes));
  if (half <= 0.0) return std::nullopt;
  double low = 0.0, high = 1e-3;
  while (points_within(high, planes) < half && high < 1e6) high *= 2.0;
  while (high - low > 1e-6) {
    const double middle = 0.5 * (low + high);
    (points_within(middle, planes) < half ? low : high) = middle;
  }
  return high;
}

std::size_t point_count(const std::vector<Plane>& planes) {
  std::size_t count = 0;
  for (const Plane& plane : planes) {
    for (const PlaneCell& cell : plane.cells) count += cell.count;
  }
  return count;
}

}  // namespace ribbon_mapper
