// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <optional>

#include "modeler/floor_plan/plan_openings.hpp"

namespace ribbon_mapper {
namespace {

/// Which opening and jamb a leaf hangs at.
struct Hanging {
  std::size_t opening, jamb;
  PlanLeaf leaf;
};

double width_m(const PlanLeaf& leaf) { return (leaf.tip - leaf.hinge).norm(); }

/// Returns an upright plane as a leaf that hangs at one of its edges; nothing if it has no outline.
std::optional<PlanLeaf> leaf_of(const Plane& plane) {
  const Eigen::Vector2d along = Eigen::Vector2d(-plane.normal.y(), plane.normal.x()).normalized();
  std::vector<Eigen::Vector2d> points;
  for (const Outline& outline : plane.outlines) {
    for (const Eigen::Vector3d& point : outline.outer) points.push_back(point.head<2>());
  }
  if (points.empty()) return std::nullopt;
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(), [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return along.dot(a) < along.dot(b);
      });
  return PlanLeaf{plane.id, *low, *high};
}

/// Returns the distance of a point from a jamb, which goes through the whole wall [m].
double distance_m(const Eigen::Vector2d& point, const PlanOpening& opening, std::size_t jamb) {
  const Eigen::Vector2d from = point - opening.jambs[jamb];
  const double half_m = 0.5 * opening.depth_m.value_or(0.0);
  const double across_m = std::clamp(opening.normal.dot(from), -half_m, half_m);
  return (from - across_m * opening.normal).norm();
}

/// Returns where a leaf hangs: at the jamb that is nearest to one of its edges.
std::optional<Hanging> hanging_of(const PlanLeaf& leaf, const std::vector<PlanOpening>& openings,
                                  double reach_m) {
  std::optional<Hanging> best;
  const PlanLeaf turned{leaf.plane, leaf.tip, leaf.hinge};
  for (std::size_t i = 0; i < openings.size(); ++i) {
    for (const std::size_t jamb : {0U, 1U}) {
      for (const PlanLeaf& way : {leaf, turned}) {
        const double apart_m = distance_m(way.hinge, openings[i], jamb);
        if (apart_m >= reach_m) continue;
        reach_m = apart_m;
        best = Hanging{i, jamb, way};
      }
    }
  }
  return best;
}

}  // namespace

void hang_leaves(const std::vector<Plane>& planes, const Semantics& semantics,
                 const FloorPlanConfig& config, std::vector<PlanOpening>& openings) {
  std::vector<std::array<std::optional<PlanLeaf>, 2>> hung(openings.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (semantics.labels[i].label != Label::door_leaf) continue;
    const std::optional<PlanLeaf> leaf = leaf_of(planes[i]);
    if (!leaf) continue;
    const auto found = hanging_of(*leaf, openings, config.greatest_thickness_m);
    if (!found) continue;
    std::optional<PlanLeaf>& at_jamb = hung[found->opening][found->jamb];
    if (!at_jamb || width_m(found->leaf) > width_m(*at_jamb)) at_jamb = found->leaf;
  }
  for (std::size_t i = 0; i < openings.size(); ++i) {
    for (const auto& leaf : hung[i]) {
      if (leaf) openings[i].leaves.push_back(*leaf);
    }
  }
}

}  // namespace ribbon_mapper
