// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sdf/resource_finder.hpp"

#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace ribbon_mapper::sim {
namespace {

namespace fs = std::filesystem;

/// Returns the path of a URI. That of `model:` is relative, also with three slashes.
std::string without_scheme(const std::string& uri) {
  const std::size_t end = uri.find("://");
  if (end == std::string::npos) return uri;
  const bool is_model = uri.substr(0, end) == "model";
  const std::size_t start = is_model ? uri.find_first_not_of('/', end + 3) : end + 3;
  return start == std::string::npos ? "" : uri.substr(start);
}

/// Returns true if there is such a file or folder, false if that cannot be known.
bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

}  // namespace

std::string find_resource(const std::string& uri, const std::string& base_folder,
                          const std::vector<std::string>& folders) {
  const fs::path name = without_scheme(uri);
  if (name.empty()) return {};
  if (name.is_absolute()) return is_there(name) ? name.string() : std::string();
  if (is_there(base_folder / name)) return (base_folder / name).string();
  for (const std::string& folder : folders)
    if (is_there(folder / name)) return (folder / name).string();
  return {};
}

std::vector<std::string> split_path_list(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, ':');)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

void add_gazebo_paths(std::vector<std::string>& model_paths) {
  const char* list = std::getenv("GAZEBO_MODEL_PATH");
  if (list == nullptr) return;
  for (const std::string& path : split_path_list(list)) model_paths.push_back(path);
}

}  // namespace ribbon_mapper::sim
