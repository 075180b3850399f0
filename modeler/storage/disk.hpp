// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ribbon_mapper {

/// Owner of a file descriptor.
class Descriptor {
 public:
  /// Takes over a descriptor; -1 is none.
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  ~Descriptor();                                       ///< closes it
  Descriptor(Descriptor&& other) noexcept;             ///< takes it over
  Descriptor& operator=(Descriptor&& other) noexcept;  ///< closes the own one and takes it over

  /// Returns the descriptor, or -1.
  int get() const { return fd_; }
  /// Returns true if there is one.
  bool is_open() const { return fd_ >= 0; }

 private:
  int fd_;
};

/// Throws std::runtime_error: `path` cannot be written, the reason of this errno, and a remedy.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error);

/// Returns the directory that a file lies in; "." for a plain name.
std::filesystem::path directory_of(const std::filesystem::path& file);

/// Creates a directory with its parents. Throws as fail_to_write().
void create_directory_for_files(const std::filesystem::path& directory);

/// A directory for files that are written at the end of a work. It is created before the work, so
/// that a wrong name is found then.
class OutputDirectory {
 public:
  /// Creates it with its parents. Throws as fail_to_write().
  explicit OutputDirectory(const std::filesystem::path& directory);
  ~OutputDirectory();  ///< removes what it has created and nobody has written to
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

 private:
  std::vector<std::filesystem::path> created_;  // the innermost first
};

/// Opens `path` with these flags of open() and locks it against other processes until the
/// descriptor is closed. A crash releases the lock.
///
/// Returns no descriptor, and leaves the reason in errno, if that fails, or if another process
/// holds the lock (EWOULDBLOCK).
Descriptor open_locked(const std::filesystem::path& path, int flags);

/// Writes all bytes to an empty file and flushes them to the disk. Returns false, with the reason
/// in errno, if that fails.
bool write_flushed(int fd, const std::string& bytes);

/// Flushes a file or the entries of a directory to the disk. Throws as fail_to_write().
void flush(const std::filesystem::path& path);

}  // namespace ribbon_mapper
