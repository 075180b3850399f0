// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace ribbon_mapper {

/// A file that is replaced atomically. The bytes are written to a temporary file in the same
/// directory, checked and flushed to the disk; commit() renames it. Without commit() the old file
/// stays and the temporary one is removed.
class StagedFile {
 public:
  /// Writes the temporary file. Throws std::runtime_error with the file, the reason and a remedy.
  StagedFile(std::filesystem::path path, const std::string& bytes);

  /// Removes the temporary file if it was not committed.
  ~StagedFile();

  /// Takes over the temporary file.
  StagedFile(StagedFile&& other) noexcept;

  StagedFile& operator=(StagedFile&&) = delete;

  /// Replaces the file at the path by the temporary one. Throws as the constructor.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;  ///< empty after commit()
};

/// Writes a file atomically. Throws as StagedFile.
void write_file_atomically(const std::filesystem::path& path, const std::string& bytes);

/// Creates a directory with its parents. Throws as StagedFile.
void create_directory_for_files(const std::filesystem::path& directory);

}  // namespace ribbon_mapper
