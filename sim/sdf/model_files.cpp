// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sdf/model_files.hpp"

#include <filesystem>
#include <sdf/parser.hh>
#include <stdexcept>

#include "sim/sdf/resource_finder.hpp"

namespace ribbon_mapper::sim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGroundPlane =
    "<sdf version='1.9'><model name='ground_plane'><link name='link'><collision name='collision'>"
    "<geometry><plane><normal>0 0 1</normal></plane></geometry></collision></link></model></sdf>";

/// Returns the SDF file of a model's folder, or the file itself.
std::string model_file(const std::string& path) {
  if (!fs::is_directory(path)) return path;
  const std::string file = sdf::getModelFilePath(path);  // the one that its model.config names
  return fs::is_regular_file(file) ? file : path + "/model.sdf";
}

std::unique_ptr<SdfFile> world_file(const std::string& path) {
  const std::string prefix = "world " + path + ": ";
  if (!fs::is_regular_file(path))
    throw std::runtime_error(prefix +
                             "no such file; give the path of an SDF world, or a shipped one such "
                             "as worlds/apartment.sdf");
  try {
    return std::make_unique<SdfFile>(path);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(prefix + error.what() + " (check it with `ign sdf --check`)");
  }
}

}  // namespace

ModelFiles::ModelFiles(const std::string& world, const std::vector<std::string>& model_paths)
    : world_(world_file(world)), folders_{world_->folder()} {
  folders_.insert(folders_.end(), model_paths.begin(), model_paths.end());
}

std::string ModelFiles::find(const std::string& uri, const std::string& folder) const {
  return find_resource(uri, folder, folders_);
}

const SdfFile* ModelFiles::model(const std::string& uri, const SdfScope& scope,
                                 const tinyxml2::XMLElement& at) {
  const std::string found = find(uri, scope.file.folder());
  const std::string name = fs::path(uri + "/").parent_path().filename();
  if (found.empty() && name == "sun") return nullptr;
  const bool is_ground = found.empty() && name == "ground_plane";
  if (found.empty() && !is_ground)
    scope.fail(at, "needs the model " + quoted(uri) +
                       ", which was not found; add the folder that holds it to the model path "
                       "(--model-path, GAZEBO_MODEL_PATH), or remove the include");
  const std::string path = is_ground ? "ground_plane" : model_file(found);
  std::unique_ptr<SdfFile>& file = models_[path];
  if (file) return file.get();
  try {
    file = is_ground ? SdfFile::from_text(kGroundPlane, path) : std::make_unique<SdfFile>(path);
  } catch (const std::runtime_error& error) {
    scope.fail(at, "needs the model " + path + ": " + error.what());
  }
  return file.get();
}

}  // namespace ribbon_mapper::sim
