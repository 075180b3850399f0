// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "modeler/mesh/mesh_file.hpp"
#include "modeler/modeler_config.hpp"
#include "modeler/ros/intake/time_jump.hpp"
#include "modeler/ros/maps/map_server.hpp"
#include "modeler/ros/node/intake_parameters.hpp"

namespace ribbon_mapper {

/// The private parameters of the node `modeler`; README.md lists them.
struct ModelerParameters {
  IntakeParameters lines;                ///< where lines come from, and their frames
  ModelerConfig config;                  ///< of the preset
  double tf_cache_s = 0.0;               ///< how long transforms are kept
  OnTimeJump on_time_jump{};             ///< what happens when time goes back
  std::filesystem::path output_dir;      ///< absolute folder of saved models
  std::string load;                      ///< saved model to begin with; empty: none
  bool resume = false;                   ///< begin with the autosave, if it is there
  double autosave_period_s = 0.0;        ///< how often the model is saved; 0: never
  MapServerOptions maps;                 ///< maps for robots
  std::vector<MeshFormat> mesh_formats;  ///< what ~save writes for other programs
};

/// Reads the parameters. Throws std::invalid_argument with the name and what is allowed if one is
/// wrong or unknown, and as load_config() does.
ModelerParameters modeler_parameters();

}  // namespace ribbon_mapper
