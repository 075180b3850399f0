// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/node/modeler_parameters.hpp"

#include <stdexcept>

#include "modeler/io/config_file.hpp"

namespace ribbon_mapper {
namespace {

std::vector<MeshFormat> mesh_formats(StrictParameters& from) {
  const std::vector<std::string> names = from.words("mesh_formats");
  try {
    return mesh_formats_from(names);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string("parameter ~mesh_formats: ") + error.what());
  }
}

}  // namespace

ModelerParameters modeler_parameters() {
  StrictParameters from;
  ModelerParameters p;
  p.lines = intake_parameters(from);
  p.tf_cache_s = from.number("tf_cache", 120.0, 10.0, 3600.0);
  p.on_time_jump = on_time_jump_from(from.text("on_time_jump", "reset"));
  p.output_dir = std::filesystem::absolute(
      from.filled_text("output_dir", "models", "a folder for saved models"));
  p.load = from.text("load", "");
  p.resume = from.flag("resume", false);
  p.autosave_period_s = from.number("autosave_period_s", 0.0, 0.0, 86400.0);
  p.maps.period_s = from.number("map_period", 10.0, 0.0, 86400.0);
  p.mesh_formats = mesh_formats(from);
  from.refuse_unknown();
  p.config = load_config(p.lines.config_file);
  p.maps.frame = p.lines.options.frames.map;
  p.maps.directory = p.output_dir;
  p.maps.maps = p.config.maps;
  return p;
}

}  // namespace ribbon_mapper
