// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/save.hpp"

#include <regex>
#include <stdexcept>

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

void add_model(const std::vector<Plane>& planes, ModelLabel label, const std::string& name,
               double stripe_gap_m, FileSet& files, const std::vector<PlaneLabel>& labels) {
  label.origin = origin_of(planes);
  files.add(name + ".json", planes_to_json(planes, label, labels));
  files.add(name + ".ply", planes_to_ply_mesh(planes, stripe_gap_m, label));
  files.add(name + "_cells.ply", planes_to_ply_cloud(planes, label));
  files.add(name + ".bt", planes_to_octomap(planes, label));
}

std::vector<fs::path> save_model(const std::vector<Plane>& planes, const fs::path& directory,
                                 const std::string& name, double stripe_gap_m,
                                 const std::string& frame, const SavedBeside& beside) {
  check_save_name(name);
  ModelLabel label;
  label.frame = frame;
  label.run = run_id_of({planes_to_json(planes, label)});
  FileSet files(directory, name);
  add_model(planes, label, name, stripe_gap_m, files, beside.labels);
  if (!beside.model_file.empty()) files.add(name + ".ribbons", beside.model_file);
  if (beside.rooms) files.add(name + "_rooms.json", rooms_to_json(*beside.rooms, label));
  if (beside.page) files.add(name + ".html", beside.page(label.run));
  if (beside.more) beside.more(label, files);
  return files.commit();
}

}  // namespace ribbon_mapper
