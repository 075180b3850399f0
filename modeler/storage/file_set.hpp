// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "modeler/storage/disk.hpp"

namespace ribbon_mapper {

/// Name of the set that holds the results of a run in a folder. A run of any program replaces that
/// of the one before.
constexpr const char* kResultsSet = "results";

/// A set of files that one commit replaces: after a crash at any time, whoever opens them by their
/// names finds all old or all new ones.
///
/// A file `directory/name` is a symbolic link to `.<set>.set/current/name`, where `current` is a
/// symbolic link to the folder with the files. commit() replaces that one link. On disks without
/// symbolic links, files are replaced one after the other. All members that write throw
/// std::runtime_error with the file, the reason and a remedy; the old files are then unchanged.
class FileSet {
 public:
  /// Creates the directory and a folder for new files of the set `name`. Removes what crashes have
  /// left of it. Waits up to 10 s for another process that writes the same set.
  FileSet(std::filesystem::path directory, const std::string& name);

  /// Removes the new files if they were not committed.
  ~FileSet();

  FileSet(FileSet&&) noexcept;  ///< takes over the new files
  FileSet& operator=(FileSet&&) = delete;

  /// Adds a file with these bytes.
  void add(const std::string& file, const std::string& bytes);

  /// Returns the folder of the new files. What else is put there belongs to the set.
  const std::filesystem::path& folder() const { return folder_; }

  /// Replaces the old files by the new ones and flushes them to the disk. Old files without a
  /// successor are removed. Returns the paths of the new files.
  std::vector<std::filesystem::path> commit();

 private:
  std::filesystem::path own_folder() const { return directory_ / set_; }
  std::filesystem::path target_for(const std::string& file) const;
  bool has_links() const;
  void place_link(const std::string& file);
  void adopt(const std::string& file);
  void replace_link(const std::filesystem::path& target, const std::filesystem::path& link);
  void rename_into_place(const std::string& file);
  void remove_leftovers();
  void release();

  std::filesystem::path directory_;
  std::string set_;               // name of the set's own folder
  Descriptor lock_;               // of that folder
  std::filesystem::path folder_;  // empty after commit()
};

}  // namespace ribbon_mapper
