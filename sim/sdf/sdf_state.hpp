// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "modeler/geometry/pose.hpp"
#include "sim/sdf/sdf_file.hpp"

namespace ribbon_mapper::sim {

/// The <state> of a world: where Gazebo Classic places models and links when it loads the world.
/// All poses are in the world's frame.
class SdfState {
 public:
  /// Adds the models of a <state> element. Throws as SdfScope::fail().
  void add(const tinyxml2::XMLElement& state, const SdfScope& scope);

  /// Returns the pose of a model or of model::link, nothing if the state does not tell.
  std::optional<Pose> T_map(const std::string& name) const;
  /// Returns the factors for the sizes of a model's shapes.
  Eigen::Vector3d scale(const std::string& model) const;
  /// Returns true if a model of the world was deleted.
  bool is_deleted(const std::string& model) const { return deleted_.count(model) > 0; }

 private:
  void add_part(const tinyxml2::XMLElement& part, const SdfScope& scope);

  // By names whose "::" are replaced: Gazebo Classic writes nested::link for links of nested
  // models.
  std::map<std::string, Pose> poses_;
  std::map<std::string, Eigen::Vector3d> scales_;
  std::set<std::string> deleted_;
};

}  // namespace ribbon_mapper::sim
