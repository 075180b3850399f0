// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace ribbon_mapper {

/// A file that appears whole or not at all. The bytes go to a temporary file in the same directory,
/// are checked and flushed to the disk; commit() then puts it in the place of the old file. Without
/// commit() the old file stays and nothing is left of the new one.
class StagedFile {
 public:
  /// Writes the temporary file. Throws std::runtime_error that says which file could not be
  /// written, why, and what to do about it.
  StagedFile(std::filesystem::path path, const std::string& bytes);
  ~StagedFile();
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;

  /// Throws as the constructor does.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;  ///< empty once there is none
};

/// Stages and commits. Throws as StagedFile does.
void write_file_atomically(const std::filesystem::path& path, const std::string& bytes);

/// Creates the directory and those above it. Throws as StagedFile does.
void create_directory_for_files(const std::filesystem::path& directory);

}  // namespace ribbon_mapper
