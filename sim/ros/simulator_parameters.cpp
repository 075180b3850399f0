// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/ros/simulator_parameters.hpp"

#include <cstdlib>
#include <limits>
#include <sstream>

#include "modeler/program/installed_files.hpp"
#include "modeler/ros/node/strict_parameters.hpp"

namespace ribbon_mapper::sim {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

std::string gazebo_model_path() {
  const char* path = std::getenv("GAZEBO_MODEL_PATH");
  return path ? path : "";
}

std::string required_file(StrictParameters& from, const std::string& name,
                          const std::string& what) {
  return find_installed_file(from.required_text(name, what)).string();
}

/// Reads a preset by name, or `linear` with its period, amplitude and offset.
TiltProfileConfig read_tilt(StrictParameters& from) {
  const std::string profile = from.text("tilt_profile", "manip");
  const double period_s = from.number("tilt_period", 3.0, 0.1, 600.0);
  const double amplitude_rad = from.number("tilt_amplitude", 0.75, 0.0, 1.5);
  const double offset_rad = from.number("tilt_offset", 0.25, -1.5, 1.5);
  if (profile != "linear") return TiltProfileConfig::preset(profile);
  return TiltProfileConfig::linear(period_s, amplitude_rad, offset_rad);
}

HokuyoConfig read_hokuyo(StrictParameters& from) {
  HokuyoConfig hokuyo;
  hokuyo.angle_min_rad = from.number("angle_min", hokuyo.angle_min_rad, -2.3562, 0.0);
  hokuyo.angle_max_rad = from.number("angle_max", hokuyo.angle_max_rad, 0.0, 2.3562);
  hokuyo.noise = range_noise_from(from.text("noise", "datasheet"));
  hokuyo.noise_scale = from.number("noise_scale", hokuyo.noise_scale, 0.0, 100.0);
  hokuyo.mixed_pixels = from.flag("mixed_pixels", hokuyo.mixed_pixels);
  return hokuyo;
}

}  // namespace

SimulatorParameters SimulatorParameters::read() {
  StrictParameters from;
  SimulatorParameters p;
  p.world = required_file(from, "world", "an SDF file, such as worlds/apartment.sdf");
  p.route = required_file(from, "route", "a YAML file, such as worlds/apartment.route.yaml");
  p.model_paths = split(from.text("model_path", gazebo_model_path()), ':');
  p.visuals = from.flag("visuals", false);
  p.caster = ray_caster_kind_from(from.text("caster", "bullet"));
  p.tour.seed =
      static_cast<std::uint64_t>(from.integer("seed", 1, 0, std::numeric_limits<int>::max()));
  p.tour.localisation.drift = from.number("drift", 1.0, 0.0, 100.0);
  p.tour.localisation.faults = OdometryFaults::from(from.text("odometry_faults", ""));
  p.tour.hokuyo = read_hokuyo(from);
  p.tour.base_hokuyo.noise = p.tour.hokuyo.noise;
  p.tour.base_hokuyo.noise_scale = p.tour.hokuyo.noise_scale;
  p.tour.base_hokuyo.mixed_pixels = p.tour.hokuyo.mixed_pixels;
  p.tour.tilt = read_tilt(from);
  p.frames.map = from.text("map_frame", p.frames.map);
  p.frames.odom = from.text("odom_frame", p.frames.odom);
  p.frames.base = from.text("base_frame", p.frames.base);
  p.localisation = from.flag("localisation", true);
  p.rate = from.number("rate", 1.0, 0.01, 100.0);
  p.wait_for = split(from.text("wait_for", "tilt_scan joint_states"), ' ');
  p.longest_wait_s = from.number("longest_wait", 30.0, 0.0, 3600.0);
  from.refuse_unknown();
  p.tour.hokuyo.validate();
  p.tour.tilt.validate();
  p.tour.localisation.validate();
  return p;
}

}  // namespace ribbon_mapper::sim
