// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/storage/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "modeler/storage/disk.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;

/// Number of temporary names: of processes that may write the same file at the same time.
constexpr int kTemporaryNames = 100;

fs::path temporary_name(const fs::path& path, int number) {
  return directory_of(path) / ("." + path.filename().string() + ".tmp" + std::to_string(number));
}

/// A temporary file. It is locked, so that others can tell it from the leftover of a crash.
class Temporary {
 public:
  /// Creates the file, or takes over what a crash has left.
  explicit Temporary(const fs::path& path) : path_(path) {
    for (int i = 0; i < kTemporaryNames && !file_.is_open(); ++i) {
      name_ = temporary_name(path, i);
      file_ = open_locked(name_, O_WRONLY | O_CREAT);
      if (!file_.is_open() && errno != EWOULDBLOCK) fail_to_write(path, errno);
    }
    if (!file_.is_open()) fail_to_write(path, errno);
  }

  /// Removes the file if it was not renamed.
  ~Temporary() {
    if (!name_.empty()) ::unlink(name_.c_str());
  }

  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  void write(const std::string& bytes) {
    if (::ftruncate(file_.get(), 0) != 0 || !write_flushed(file_.get(), bytes)) {
      fail_to_write(path_, errno);
    }
  }

  void rename() {
    if (::rename(name_.c_str(), path_.c_str()) != 0) fail_to_write(path_, errno);
    name_.clear();
    flush(directory_of(path_));
  }

 private:
  fs::path path_, name_;
  Descriptor file_;
};

}  // namespace

void write_file_atomically(const fs::path& path, const std::string& bytes) {
  {
    Temporary file(path);
    file.write(bytes);
    file.rename();
  }
  remove_leftovers_of(path);
}

void remove_leftovers_of(const fs::path& path) {
  for (int i = 0; i < kTemporaryNames; ++i) {
    const fs::path name = temporary_name(path, i);
    const Descriptor file = open_locked(name, O_WRONLY);
    if (file.is_open()) ::unlink(name.c_str());
  }
}

}  // namespace ribbon_mapper
