// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/semantics/semantics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modeler/semantics/scene.hpp"
#include "modeler/semantics/upright_rules.hpp"

namespace ribbon_mapper {
namespace {

/// Returns how sure it is that a plane stands as its shape says.
double attitude_certainty(const PlaneShape& shape, const LabelConfig& config) {
  const double off_level_deg = std::min(shape.tilt_deg, 180.0 - shape.tilt_deg);
  const double margin_deg = std::min(std::abs(off_level_deg - config.level_deg),
                                     std::abs(off_level_deg - (90.0 - config.upright_deg)));
  return certainty(margin_deg, std::hypot(shape.tilt_sigma_deg, config.tilt_sigma_deg));
}

Decision level_up_label(std::size_t plane, const Scene& scene) {
  if (!scene.main_floor()) return {};
  const double above_m =
      scene.planes()[plane].centroid.z() - scene.planes()[*scene.main_floor()].centroid.z();
  const double margin_m = std::abs(above_m) - scene.config().floor_step_m;
  const double sigma_m = 0.5 * scene.config().floor_step_m;
  const double sure = scene.is_driven(plane) ? 1.0 : certainty(margin_m, sigma_m);
  return {scene.is_floor(plane) ? Label::floor : Label::top, sure};
}

Decision tilted_up_label(std::size_t plane, const Scene& scene) {
  const Plane& p = scene.planes()[plane];
  const PlaneShape& shape = scene.shape(plane);
  if (scene.is_driven(plane)) return {Label::slope, 1.0};
  // A ramp begins at the floor. A step more, since its foot is thin.
  const double foot_m =
      shape.lowest_m - scene.floor_height_m({p.centroid.x(), p.centroid.y(), shape.highest_m});
  const double limit_m = 2.0 * scene.config().floor_step_m;
  return {foot_m <= limit_m ? Label::slope : Label::furniture,
          certainty(foot_m - limit_m, scene.config().size_sigma_m)};
}

/// Decides on a plane that is seen from below: `label` if it is over people's heads.
Decision overhead_label(Label label, std::size_t plane, const Scene& scene) {
  const Eigen::Vector3d& centroid = scene.planes()[plane].centroid;
  const double clear_m = scene.shape(plane).highest_m - scene.floor_height_m(centroid);
  const double margin_m = clear_m - scene.config().head_height_m;
  return {margin_m >= 0.0 ? label : Label::furniture,
          certainty(margin_m, scene.config().size_sigma_m)};
}

Decision label_of(std::size_t plane, const Scene& scene) {
  switch (scene.shape(plane).attitude) {
    case Attitude::level_up:
      return level_up_label(plane, scene);
    case Attitude::tilted_up:
      return tilted_up_label(plane, scene);
    case Attitude::level_down:
      return overhead_label(Label::ceiling, plane, scene);
    case Attitude::tilted_down:
      return overhead_label(Label::slope, plane, scene);
    case Attitude::upright:
      break;
  }
  return wall_or_furniture(plane, scene);
}

void find_doors(const Scene& scene, Semantics& semantics) {
  std::vector<bool> is_wall;
  for (const Decision& decision : semantics.labels) {
    is_wall.push_back(decision.label == Label::wall);
  }
  semantics.openings = door_openings_in(is_wall, scene);
  std::vector<bool> has_leaf(semantics.openings.size());
  for (std::size_t i = 0; i < scene.planes().size(); ++i) {
    Decision& decision = semantics.labels[i];
    if (scene.shape(i).columns.empty() || decision.label == Label::wall) continue;
    const std::vector<std::size_t> hung = openings_of_leaf(i, semantics.openings, scene);
    for (const std::size_t opening : hung) has_leaf[opening] = true;
    if (!hung.empty()) decision.label = Label::door_leaf;
    if (is_reveal(i, semantics.openings, scene)) decision.label = Label::wall;
  }
  std::vector<DoorOpening> doors;
  for (std::size_t i = 0; i < has_leaf.size(); ++i) {
    if (semantics.openings[i].is_passable || has_leaf[i]) doors.push_back(semantics.openings[i]);
  }
  semantics.openings = std::move(doors);
}

}  // namespace

Semantics semantics_of(const std::vector<Plane>& planes, const std::vector<Eigen::Vector3d>& driven,
                       const LabelConfig& config) {
  const Scene scene(planes, driven, config);
  Semantics semantics;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (planes[i].cells.empty()) {
      semantics.labels.push_back({});
      continue;
    }
    semantics.labels.push_back(
        given(label_of(i, scene), attitude_certainty(scene.shape(i), config)));
  }
  find_doors(scene, semantics);
  return semantics;
}

std::vector<Eigen::Vector3d> positions_of(const std::vector<StampedPose>& trajectory) {
  std::vector<Eigen::Vector3d> positions;
  for (const StampedPose& pose : trajectory) positions.push_back(pose.T_map_base.translation());
  return positions;
}

}  // namespace ribbon_mapper
