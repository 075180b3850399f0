// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/floor_plan/floor_plan.hpp"
#include "modeler/io/model_label.hpp"
#include "modeler/mesh/mesh_file.hpp"
#include "modeler/semantics/plane_label.hpp"
#include "modeler/storage/file_set.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Adds the outlines of planes to a set as <name>.glb, <name>.obj with <name>.mtl, and <name>.stl,
/// as the formats demand: see mesh_files(). The label's origin is replaced by origin_of(). `labels`
/// are those of the planes, or none. A model without outlines has no such file.
void add_meshes(const std::vector<Plane>& planes, ModelLabel label,
                const std::vector<PlaneLabel>& labels, const std::vector<MeshFormat>& formats,
                const std::string& name, FileSet& files);

/// Adds a floor plan to a set as <name>.geojson.
void add_floor_plan(const FloorPlan& plan, const ModelLabel& label, const std::string& name,
                    FileSet& files);

}  // namespace ribbon_mapper
