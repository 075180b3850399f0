// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim/sdf/sdf_file.hpp"

namespace ribbon_mapper::sim {

/// The file of a world and those that it refers to, each read once.
class ModelFiles {
 public:
  /// Reads the file of the world. Throws std::runtime_error that names it and says what to do.
  ModelFiles(const std::string& world, const std::vector<std::string>& model_paths);

  /// Returns the file of the world.
  const SdfFile& world() const { return *world_; }

  /// Returns the path that a URI refers to, empty if there is none. Looks in `folder`, beside the
  /// world, then in the model paths.
  std::string find(const std::string& uri, const std::string& folder) const;

  /// Returns the file of an included model; null for Gazebo's sun, which is a light. Gazebo's
  /// ground plane needs no file. Throws as SdfScope::fail() if there is no such model.
  const SdfFile* model(const std::string& uri, const SdfScope& scope,
                       const tinyxml2::XMLElement& at);

 private:
  std::unique_ptr<SdfFile> world_;
  std::vector<std::string> folders_;
  std::map<std::string, std::unique_ptr<SdfFile>> models_;  ///< by path
};

}  // namespace ribbon_mapper::sim
