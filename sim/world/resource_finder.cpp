// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/resource_finder.hpp"

#include <filesystem>
#include <sstream>

namespace ribbon_mapper::sim {
namespace {

namespace fs = std::filesystem;

std::string without_scheme(const std::string& uri) {
  const std::size_t end = uri.find("://");
  return end == std::string::npos ? uri : uri.substr(end + 3);
}

}  // namespace

std::string find_resource(const std::string& uri, const std::string& base_folder,
                          const std::vector<std::string>& folders) {
  const fs::path name = without_scheme(uri);
  if (name.empty()) return {};
  if (name.is_absolute()) return fs::exists(name) ? name.string() : std::string();
  if (fs::exists(base_folder / name)) return (base_folder / name).string();
  for (const std::string& folder : folders)
    if (fs::exists(folder / name)) return (folder / name).string();
  return {};
}

std::vector<std::string> split_path_list(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, ':');)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

}  // namespace ribbon_mapper::sim
