// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

#include "modeler/ros/intake/line_intake.hpp"
#include "modeler/ros/node/strict_parameters.hpp"

namespace ribbon_mapper {

/// What every node that takes scan lines is told by its parameters.
struct IntakeParameters {
  std::string config_file;               ///< the preset
  IntakeOptions options;                 ///< frames and times
  std::set<std::string> tf_drop_frames;  ///< see enter_transforms()
};

/// Reads ~config, ~map_frame, ~odom_frame, ~base_frame, ~transform_timeout, ~scan_time_offset and
/// ~tf_drop_frames. Throws std::invalid_argument as StrictParameters does.
IntakeParameters intake_parameters(StrictParameters& from);

}  // namespace ribbon_mapper
