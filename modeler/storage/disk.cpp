// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/storage/disk.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;

std::string advice_for(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "free some space there or choose another directory";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a directory that you may write to";
    case ENOENT:
    case ENOTDIR:
      return "create the directory or choose another one";
    case EISDIR:
      return "a directory has this name: move it away or choose another directory";
    case EWOULDBLOCK:
      return "another process writes it now: wait until that is done";
    default:
      return "check the disk or choose another directory";
  }
}

bool write_all(int fd, const std::string& bytes) {
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t n = ::write(fd, bytes.data() + written, bytes.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    written += static_cast<std::size_t>(n);
  }
  return true;
}

bool has_size(int fd, std::size_t size) {
  struct stat status {};
  if (::fstat(fd, &status) != 0) return false;
  if (static_cast<std::size_t>(status.st_size) == size) return true;
  errno = EIO;
  return false;
}

/// Returns true if `path` still leads to what was opened: nobody has moved or removed it since.
bool leads_to(const fs::path& path, int fd) {
  struct stat now {
  }, opened{};
  return ::stat(path.c_str(), &now) == 0 && ::fstat(fd, &opened) == 0 &&
         now.st_dev == opened.st_dev && now.st_ino == opened.st_ino;
}

/// Locks what was opened. Some network disks have no locks: then two processes must not write the
/// same file at the same time.
bool lock(int fd) { return ::flock(fd, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK; }

}  // namespace

Descriptor::~Descriptor() {
  if (fd_ >= 0) ::close(fd_);
}

Descriptor::Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

void fail_to_write(const fs::path& path, int error) {
  throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(error) + "; " +
                           advice_for(error));
}

fs::path directory_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

void create_directory_for_files(const fs::path& directory) {
  if (directory.empty()) {
    throw std::runtime_error("the name of the output directory is empty: name one, or . for here");
  }
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) fail_to_write(directory, error.value());
}

OutputDirectory::OutputDirectory(const fs::path& directory) {
  std::error_code error;
  const fs::path whole = (fs::absolute(directory, error) / "").parent_path();
  for (fs::path path = whole; !fs::exists(path, error) && path.has_relative_path();
       path = path.parent_path()) {
    created_.push_back(path);
  }
  create_directory_for_files(directory);
}

OutputDirectory::~OutputDirectory() {
  for (const fs::path& path : created_) ::rmdir(path.c_str());  // fails if there are files
}

Descriptor open_locked(const fs::path& path, int flags) {
  while (true) {
    Descriptor opened(::open(path.c_str(), flags | O_CLOEXEC, 0666));
    if (!opened.is_open() || !lock(opened.get())) return Descriptor();
    if (leads_to(path, opened.get())) return opened;
  }
}

bool write_flushed(int fd, const std::string& bytes) {
  return write_all(fd, bytes) && has_size(fd, bytes.size()) && ::fsync(fd) == 0;
}

void flush(const fs::path& path) {
  const Descriptor fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!fd.is_open() || ::fsync(fd.get()) != 0) fail_to_write(path, errno);
}

}  // namespace ribbon_mapper
