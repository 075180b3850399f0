// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/node/intake_parameters.hpp"

#include "modeler/program/installed_files.hpp"
#include "modeler/ros/messages/transform_entry.hpp"

namespace ribbon_mapper {

IntakeParameters intake_parameters(StrictParameters& from) {
  IntakeParameters p;
  p.config_file =
      find_installed_file(from.required_text("config", "a YAML file, such as config/pr2.yaml"))
          .string();
  Frames& frames = p.options.frames;
  frames.map = from.frame("map_frame", frames.map);
  frames.odom = from.frame("odom_frame", frames.odom);
  frames.base = from.frame("base_frame", frames.base);
  p.options.transform_timeout_s =
      from.number("transform_timeout", p.options.transform_timeout_s, 0.1, 60.0);
  p.options.scan_time_offset_s =
      from.number("scan_time_offset", p.options.scan_time_offset_s, -1.0, 1.0);
  p.tf_drop_frames = frames_from(from.text("tf_drop_frames", ""));
  return p;
}

}  // namespace ribbon_mapper
