// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sdf/unique_names.hpp"

#include <map>
#include <set>
#include <string>

namespace ribbon_mapper::sim {

std::size_t make_names_unique(tinyxml2::XMLElement& parent) {
  std::set<std::string> names;
  std::map<std::string, std::size_t> next_suffix;
  std::size_t renamed = 0;
  for (auto* child = parent.FirstChildElement(); child; child = child->NextSiblingElement()) {
    renamed += make_names_unique(*child);
    const char* name = child->Attribute("name");
    if (name == nullptr || names.insert(name).second) continue;
    const std::string base = name;
    std::string unique;
    do unique = base + "_" + std::to_string(next_suffix[base]++);
    while (!names.insert(unique).second);
    child->SetAttribute("name", unique.c_str());
    ++renamed;
  }
  return renamed;
}

}  // namespace ribbon_mapper::sim
