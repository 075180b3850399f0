// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace ribbon_mapper {

/// Where config/, worlds/ and the figure scripts are: beside the installed programs, otherwise in
/// the sources that they were built from.
std::filesystem::path installed_directory();

/// `path` if there is such a file, otherwise the one of that name in the share directory; `path` if
/// there is neither.
std::filesystem::path find_installed_file(const std::filesystem::path& path);

/// The inverse, for records that other machines can follow: a path within the share directory as
/// seen from there, others as they are.
std::filesystem::path portable_name(const std::filesystem::path& path);

}  // namespace ribbon_mapper
