// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "modeler/mesh/mesh_file.hpp"

namespace ribbon_mapper {
namespace {

MeshFormat mesh_format_from(const std::string& name) {
  if (name == "glb") return MeshFormat::gltf;
  if (name == "obj") return MeshFormat::obj;
  if (name == "stl") return MeshFormat::stl;
  throw std::invalid_argument("there is no mesh format '" + name +
                              "': name any of glb, obj and stl, separated by commas, or none");
}

}  // namespace

std::vector<MeshFormat> mesh_formats_from(const std::vector<std::string>& names) {
  std::vector<MeshFormat> formats;
  if (names == std::vector<std::string>{"none"}) return formats;
  for (const std::string& name : names) {
    const MeshFormat format = mesh_format_from(name);
    if (std::find(formats.begin(), formats.end(), format) == formats.end()) {
      formats.push_back(format);
    }
  }
  return formats;
}

std::vector<MeshFormat> mesh_formats_from(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream parts(list);
  for (std::string name; std::getline(parts, name, ',');) {
    const auto begin = name.find_first_not_of(' '), end = name.find_last_not_of(' ');
    names.push_back(begin == std::string::npos ? "" : name.substr(begin, end - begin + 1));
  }
  return mesh_formats_from(names);
}

}  // namespace ribbon_mapper
