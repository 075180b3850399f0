// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "modeler/mesh/mesh_file.hpp"

namespace ribbon_mapper {

/// Returns a validator whose error message is that of the exception that `parse` throws.
template <typename Parse>
CLI::Validator accepted_by(Parse parse) {
  return CLI::Validator(
      [parse](const std::string& text) -> std::string {
        try {
          parse(text);
          return "";
        } catch (const std::invalid_argument& error) {
          return error.what();
        }
      },
      "");
}

/// Adds what a program offers to write beside its results: --floor-plan and --mesh-formats. Both
/// destinations must outlive the parsing.
inline void add_export_options(CLI::App& app, bool& with_floor_plan,
                               std::vector<MeshFormat>& mesh_formats) {
  const auto formats_from = [](const std::string& list) { return mesh_formats_from(list); };
  app.add_flag("--floor-plan", with_floor_plan,
               "draw floor_plan.svg, .png and .dxf from floor_plan.geojson");
  app.add_option_function<std::string>(
         "--mesh-formats",
         [&mesh_formats, formats_from](const std::string& list) {
           mesh_formats = formats_from(list);
         },
         "files of the planes for other programs: glb, obj, stl, separated by commas, or none")
      ->check(accepted_by(formats_from))
      ->default_str("glb");
}

}  // namespace ribbon_mapper
