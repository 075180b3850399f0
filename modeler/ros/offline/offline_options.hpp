// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "modeler/mesh/mesh_file.hpp"
#include "modeler/ros/bag/bag_lines.hpp"

namespace ribbon_mapper {

/// The preset where none is named.
constexpr const char* kPreset = "config/pr2.yaml";

/// Command line options of `offline_modeler`.
struct OfflineOptions {
  std::vector<std::filesystem::path> bags;  ///< read as one
  std::filesystem::path trajectory;         ///< TUM file or "self"; empty: the recorded poses
  std::string base_scan;         ///< topic of a level laser that refines the odometry; empty: none
  bool poses_are_final = false;  ///< the recorded poses are as good as corrected ones
  std::string config;            ///< preset; empty: that of `load`, or kPreset
  std::filesystem::path load;    ///< model file to go on from; empty: none
  std::filesystem::path output = "results/offline";        ///< folder for the results
  bool with_figure = false;                                ///< also draws model_views.png
  bool with_maps = false;                                  ///< also writes the maps for robots
  bool with_floor_plan = false;                            ///< also draws the floor plan
  std::vector<MeshFormat> mesh_formats{MeshFormat::gltf};  ///< of the mesh of the planes
  BagOptions bag;                                          ///< topic, frames and times

  /// Returns whether the trajectory is estimated from odometry and planes.
  bool estimates_trajectory() const { return trajectory == "self"; }
};

/// Returns the options, or the exit code if the program has printed its help (0) or a usage error
/// (2).
std::variant<OfflineOptions, int> parse_offline_options(int argc, const char* const* argv);

}  // namespace ribbon_mapper
