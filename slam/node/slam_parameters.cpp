// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/node/slam_parameters.hpp"

#include <stdexcept>

#include "modeler/io/config_file.hpp"

namespace ribbon_mapper::slam {
namespace {

EstimateConfig estimate_config(StrictParameters& from) {
  EstimateConfig c;
  c.first_noise_scale = from.number("first_noise_scale", c.first_noise_scale, 0.1, 100.0);
  c.first_spatial_scale = from.number("first_spatial_scale", c.first_spatial_scale, 0.01, 100.0);
  c.window_step_s = from.number("window_step", c.window_step_s, 0.1, 60.0);
  c.window_s = from.number("window", c.window_s, 1.0, 600.0);
  c.context_radius_m = from.number("context_radius", c.context_radius_m, 0.1, 100.0);
  c.max_context_lines = from.integer("max_context_lines", c.max_context_lines, 1, 1'000'000);
  return c;
}

}  // namespace

SlamParameters SlamParameters::read() {
  StrictParameters from;
  SlamParameters p;
  p.lines = intake_parameters(from);
  p.estimate = estimate_config(from);
  p.tf_cache_s = from.number("tf_cache", 120.0, 10.0, 3600.0);
  p.transform_tolerance_s = from.number("transform_tolerance", 0.1, 0.0, 1.0);
  p.publish_tf = from.flag("publish_tf", true);
  p.base_scan = from.text("base_scan", "");
  p.on_time_jump = on_time_jump_from(from.text("on_time_jump", "reset"));
  from.refuse_unknown();
  Frames& frames = p.lines.options.frames;
  if (frames.map == frames.odom) {
    throw std::invalid_argument("parameters map_frame and odom_frame are both '" + frames.map +
                                "': the map is a frame of its own, above odometry");
  }
  p.map_frame = frames.map;
  frames.map = frames.odom;
  p.config = load_config(p.lines.config_file);
  if (p.publish_tf && !p.config.trajectory.poses_follow) {
    throw std::invalid_argument("trajectory.poses_follow is false in " + p.lines.config_file +
                                ", but map -> odom of this node follows its corrections: set it "
                                "to true for the modeler, or publish_tf to false");
  }
  return p;
}

const char* consequence_of(OnTimeJump choice) {
  switch (choice) {
    case OnTimeJump::reset:
      return "the estimate starts again (~on_time_jump reset)";
    case OnTimeJump::stop:
      return "the estimate stays and takes no lines until ~reset";
    case OnTimeJump::go_on:
      return "the estimate stays; lines older than its newest are dropped";
  }
  return "";
}

}  // namespace ribbon_mapper::slam
