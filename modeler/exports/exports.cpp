// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/exports/exports.hpp"

#include <nlohmann/json.hpp>

#include "modeler/exports/floor_plan_geojson.hpp"

namespace ribbon_mapper {
namespace {

/// Returns the text with bytes that are no UTF-8 replaced, as glTF demands.
std::string as_utf8(const std::string& text) {
  using nlohmann::json;
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace))
      .get<std::string>();
}

}  // namespace

void add_meshes(const std::vector<Plane>& planes, ModelLabel label,
                const std::vector<PlaneLabel>& labels, const std::vector<MeshFormat>& formats,
                const std::string& name, FileSet& files) {
  if (formats.empty()) return;
  label.origin = origin_of(planes);
  std::vector<std::string> texts;
  for (const PlaneLabel& plane : labels) texts.push_back(as_utf8(plane.text));
  const std::vector<PlaneMesh> meshes = meshes_of(planes, texts);
  for (const MeshFormat format : formats) {
    for (const MeshFile& file : mesh_files(meshes, format, name, label)) {
      files.add(name + file.suffix, file.bytes);
    }
  }
}

void add_floor_plan(const FloorPlan& plan, const ModelLabel& label, const std::string& name,
                    FileSet& files) {
  files.add(name + ".geojson", floor_plan_to_geojson(plan, label));
}

}  // namespace ribbon_mapper
