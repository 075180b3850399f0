// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace ribbon_mapper {

/// Returns the folder with config/, worlds/ and the figure scripts: the package's share folder if
/// the program is installed, otherwise the source folder that it was built from.
std::filesystem::path installed_directory();

/// Returns `path` if the file exists, otherwise the file of that name in installed_directory().
/// Returns `path` if neither exists.
std::filesystem::path find_installed_file(const std::filesystem::path& path);

/// Returns the name of a file for logs that are read on other machines: relative to
/// installed_directory() for files in it, unchanged for others.
std::filesystem::path portable_name(const std::filesystem::path& path);

}  // namespace ribbon_mapper
