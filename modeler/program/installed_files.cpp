// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/program/installed_files.hpp"

#include <system_error>

namespace ribbon_mapper {

namespace fs = std::filesystem;

fs::path installed_directory() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);  // <prefix>/lib/<package>/*
  const fs::path prefix = program.parent_path().parent_path().parent_path();
  fs::path installed = prefix / "share" / "ribbon_mapper";
  if (!error && fs::exists(installed / "config", error)) return installed;
  return RIBBON_MAPPER_SOURCE_DIR;
}

fs::path find_installed_file(const fs::path& path) {
  std::error_code error;
  if (fs::exists(path, error)) return path;
  fs::path shared = installed_directory() / path;
  return fs::exists(shared, error) ? shared : path;
}

fs::path portable_name(const fs::path& path) {
  const fs::path name = path.lexically_normal().lexically_relative(installed_directory());
  return name.empty() || *name.begin() == ".." ? path : name;
}

}  // namespace ribbon_mapper
