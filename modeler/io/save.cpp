// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/save.hpp"

#include <regex>
#include <stdexcept>

#include "modeler/io/atomic_file.hpp"
#include "modeler/io/octomap.hpp"
#include "modeler/io/planes_json.hpp"
#include "modeler/io/ply.hpp"

namespace ribbon_mapper {

namespace fs = std::filesystem;

void check_save_name(const std::string& name) {
  static const std::regex kAllowed("[A-Za-z0-9_][A-Za-z0-9_.-]{0,63}");
  if (std::regex_match(name, kAllowed) && name.find("..") == std::string::npos) return;
  throw std::invalid_argument(
      "save takes a name, not a path: a letter, digit or '_', then up to 63 letters, digits, '_', "
      "'.' or '-', without '..'; got \"" +
      name + "\"");
}

std::vector<fs::path> save_model(const std::vector<Plane>& planes, const fs::path& directory,
                                 const std::string& name, double stripe_gap_m) {
  check_save_name(name);
  create_directory_for_files(directory);
  std::vector<fs::path> paths{directory / (name + ".json"), directory / (name + ".ply"),
                              directory / (name + "_cells.ply"), directory / (name + ".bt")};
  std::vector<StagedFile> files;
  files.emplace_back(paths[0], planes_to_json(planes));
  files.emplace_back(paths[1], planes_to_ply_mesh(planes, stripe_gap_m));
  files.emplace_back(paths[2], planes_to_ply_cloud(planes));
  files.emplace_back(paths[3], planes_to_octomap(planes));
  for (StagedFile& file : files) file.commit();
  return paths;
}

}  // namespace ribbon_mapper
