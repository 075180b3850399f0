// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sdf/sdf_state.hpp"

#include <Eigen/Geometry>

#include "sim/sdf/sdf_geometry.hpp"

namespace ribbon_mapper::sim {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;
using tinyxml2::XMLElement;

/// Returns the pose of "x y z roll pitch yaw", whose turns are about fixed axes.
Pose to_pose(const std::vector<double>& values) {
  Pose pose = Pose::Identity();
  pose.linear() =
      (AngleAxisd(values[5], Vector3d::UnitZ()) * AngleAxisd(values[4], Vector3d::UnitY()) *
       AngleAxisd(values[3], Vector3d::UnitX()))
          .toRotationMatrix();
  pose.translation() = Vector3d(values[0], values[1], values[2]);
  return pose;
}

}  // namespace

void SdfState::add(const XMLElement& state, const SdfScope& scope) {
  for_each_child(state, [&](const XMLElement& child) {
    if (child.Name() == std::string("model")) add_part(child, scope.of(child));
    if (child.Name() == std::string("deletions"))
      for_each_child(
          child, [&](const XMLElement& name) { deleted_.insert(valid_name(text_of(name), "")); });
  });
}

void SdfState::add_part(const XMLElement& part, const SdfScope& scope) {
  const std::string name = without_colons(scope.name);
  if (const XMLElement* pose = part.FirstChildElement("pose"))
    if (!text_of(*pose).empty())
      poses_.emplace(name, to_pose(scope.numbers(*pose, 6, kCoordinate_m)));
  if (const XMLElement* scale = part.FirstChildElement("scale"))
    scales_.emplace(name, Vector3d(scope.numbers(*scale, 3, kLength_m).data()));
  for_each_child(part, [&](const XMLElement& child) {
    const std::string kind = child.Name();
    if (kind == "link" || kind == "model") add_part(child, scope.of(child));
  });
}

std::optional<Pose> SdfState::T_map(const std::string& name) const {
  const auto found = poses_.find(without_colons(name));
  return found == poses_.end() ? std::nullopt : std::optional(found->second);
}

Vector3d SdfState::scale(const std::string& model) const {
  const auto found = scales_.find(without_colons(model));
  return found == scales_.end() ? Vector3d::Ones().eval() : found->second;
}

}  // namespace ribbon_mapper::sim
