// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace ribbon_mapper {

/// Replaces a file by one with these bytes: after a crash at any time, the file is the old or the
/// new one. They are written to a temporary file beside it, which is then renamed.
///
/// Removes the temporary files that crashes have left of this one. Throws std::runtime_error with
/// the file, the reason and a remedy; the old file is then unchanged.
void write_file_atomically(const std::filesystem::path& path, const std::string& bytes);

/// Removes the temporary files of write_file_atomically() that crashes have left of this file.
void remove_leftovers_of(const std::filesystem::path& path);

}  // namespace ribbon_mapper
