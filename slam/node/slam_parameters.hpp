// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "modeler/modeler_config.hpp"
#include "modeler/ros/intake/time_jump.hpp"
#include "modeler/ros/node/intake_parameters.hpp"
#include "slam/lines/estimate_config.hpp"

namespace ribbon_mapper::slam {

/// The private parameters of the node `slam`.
struct SlamParameters {
  IntakeParameters lines;        ///< frames and times; its map frame is that of odometry
  std::string map_frame;         ///< of the estimate
  std::string base_scan;         ///< topic of a level laser on the base; empty: none
  ModelerConfig config;          ///< the preset: how ribbons are made
  EstimateConfig estimate;       ///< what belongs to the estimate alone
  double tf_cache_s;             ///< how long transforms are kept
  double transform_tolerance_s;  ///< map -> odom is stamped so much later than now
  bool publish_tf;               ///< whether map -> odom is published
  OnTimeJump on_time_jump;       ///< what happens when simulated time is set back

  /// Reads the parameters of this node. Throws std::invalid_argument that names a wrong parameter
  /// and what is allowed, or std::runtime_error about the preset.
  static SlamParameters read();
};

/// Returns the consequence of a choice, for the log.
const char* consequence_of(OnTimeJump choice);

}  // namespace ribbon_mapper::slam
