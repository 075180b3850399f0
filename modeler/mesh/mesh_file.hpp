// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/io/model_label.hpp"
#include "modeler/mesh/plane_mesh.hpp"

namespace ribbon_mapper {

/// A format that other programs read.
enum class MeshFormat {
  gltf,  ///< binary glTF 2.0 (.glb): +y is up, as the format demands
  obj,   ///< Wavefront OBJ with its materials (.obj, .mtl): z is up
  stl    ///< binary STL (.stl): z is up; without names and colours
};

/// Returns the formats of these names, each once: glb, obj or stl; none for the only name "none".
/// Throws std::invalid_argument with the list of formats for any other name.
std::vector<MeshFormat> mesh_formats_from(const std::vector<std::string>& names);

/// Returns the formats of a list such as "glb,stl"; an empty one has none. Throws as above.
std::vector<MeshFormat> mesh_formats_from(const std::string& list);

/// The bytes of a file.
struct MeshFile {
  std::string suffix;  ///< of its name, such as ".glb"
  std::string bytes;   ///< the content
};

/// Returns the files of meshes in a format, by assimp's exporter: one object per plane, with the
/// mesh's name and the colour of the plane.
///
/// Metres, less ModelLabel::origin: coordinates are of single precision. `name` is that of the
/// files, without a suffix: an OBJ names its materials. Meshes without triangles are left out. If
/// there are none, or if assimp was built without this format, there are no files. Throws
/// std::runtime_error with assimp's reason if it fails.
std::vector<MeshFile> mesh_files(const std::vector<PlaneMesh>& meshes, MeshFormat format,
                                 const std::string& name, const ModelLabel& label = {});

}  // namespace ribbon_mapper
