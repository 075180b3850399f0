// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/semantics/upright_rules.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ribbon_mapper {
namespace {

constexpr double kReachingShare = 0.1;  // of a wall's columns that are seen up to the ceiling
constexpr double kBackedShare = 0.5;
constexpr double kFilledShare = 0.6;    // of the rectangle around a leaf
constexpr double kCoveredShare = 0.7;   // of an opening by a leaf that is nearly closed
constexpr double kAcrossCosine = 0.17;  // within 10 degrees of a right angle

/// Returns the distance of a column from the nearer jamb of an opening [m].
double distance_m(const Column& column, const DoorOpening& opening) {
  return std::min((opening.jambs[0].head<2>() - column.place).norm(),
                  (opening.jambs[1].head<2>() - column.place).norm());
}

/// Returns the gap between a plane and the ceiling, where it is narrowest; nothing if no ceiling
/// was seen above it.
std::optional<double> gap_above_m(const PlaneShape& shape, const Scene& scene, double floor_m) {
  std::vector<double> gaps_m;
  for (const Column& column : shape.columns) {
    const double top_m = column.heights_m.back();
    const auto ceiling_m =
        scene.ceiling_height_m(column.place, floor_m + 0.5 * scene.config().head_height_m);
    if (ceiling_m) gaps_m.push_back(*ceiling_m - top_m);
  }
  if (gaps_m.empty()) return std::nullopt;
  return value_at(gaps_m, kReachingShare);
}

/// Returns the width of a plane along an opening, as a share of the opening's.
double share_covered(const PlaneShape& shape, const DoorOpening& opening) {
  const Eigen::Vector2d across = (opening.jambs[1] - opening.jambs[0]).head<2>();
  const double width_m = shape.end_m - shape.begin_m;
  return width_m * std::abs(shape.along.dot(across.normalized())) / across.norm();
}

}  // namespace

Decision wall_or_furniture(std::size_t plane, const Scene& scene) {
  const LabelConfig& config = scene.config();
  const PlaneShape& shape = scene.shape(plane);
  const double sigma_m = config.size_sigma_m;
  const Eigen::Vector3d& centroid = scene.planes()[plane].centroid;
  const double floor_m = scene.floor_height_m({centroid.x(), centroid.y(), shape.highest_m});
  const std::optional<double> gap_m = gap_above_m(shape, scene, floor_m);
  if (gap_m && *gap_m <= config.ceiling_gap_m) {
    return {Label::wall, certainty(config.ceiling_gap_m - *gap_m, sigma_m)};
  }
  const double height_m = shape.highest_m - floor_m, width_m = shape.end_m - shape.begin_m;
  const double backed = scene.backed_share(plane);
  if (backed >= kBackedShare) return {Label::furniture, certainty(backed - kBackedShare, 0.2)};
  if (height_m >= config.furniture_height_m) {
    return {Label::wall, certainty(height_m - config.furniture_height_m, sigma_m)};
  }
  if (height_m < config.wall_height_m) {
    return {Label::furniture, certainty(config.wall_height_m - height_m, sigma_m)};
  }
  return given({width_m >= config.wall_width_m ? Label::wall : Label::furniture,
                certainty(width_m - config.wall_width_m, sigma_m)},
               certainty(height_m - config.wall_height_m, sigma_m));
}

std::vector<std::size_t> openings_of_leaf(std::size_t plane,
                                          const std::vector<DoorOpening>& openings,
                                          const Scene& scene) {
  const LabelConfig& config = scene.config();
  const PlaneShape& shape = scene.shape(plane);
  const double width_m = shape.end_m - shape.begin_m;
  const double height_m = shape.highest_m - shape.lowest_m;
  std::vector<std::size_t> hung;
  if (width_m < config.least_door_width_m || width_m > config.greatest_leaf_width_m ||
      height_m < config.least_leaf_height_m || height_m > config.greatest_leaf_height_m ||
      scene.planes()[plane].area_m2 < kFilledShare * width_m * height_m) {
    return hung;
  }
  for (std::size_t i = 0; i < openings.size(); ++i) {
    // What hides a wall down to the floor has sides that begin where the wall is seen again.
    if (!openings[i].is_passable && share_covered(shape, openings[i]) < kCoveredShare) continue;
    if (std::min(distance_m(shape.columns.front(), openings[i]),
                 distance_m(shape.columns.back(), openings[i])) <= config.hinge_gap_m) {
      hung.push_back(i);
    }
  }
  return hung;
}

bool is_reveal(std::size_t plane, const std::vector<DoorOpening>& openings, const Scene& scene) {
  const LabelConfig& config = scene.config();
  const PlaneShape& shape = scene.shape(plane);
  return std::any_of(openings.begin(), openings.end(), [&](const DoorOpening& opening) {
    const Eigen::Vector2d along = (opening.jambs[1] - opening.jambs[0]).head<2>().normalized();
    return opening.is_passable && std::abs(shape.along.dot(along)) <= kAcrossCosine &&
           distance_m(shape.columns.front(), opening) <= config.reveal_depth_m &&
           distance_m(shape.columns.back(), opening) <= config.reveal_depth_m &&
           shape.highest_m <= opening.head_m.value_or(shape.highest_m) + config.hinge_gap_m;
  });
}

}  // namespace ribbon_mapper
