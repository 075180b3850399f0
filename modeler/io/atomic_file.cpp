// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;

/// Number of temporary names to try; a crash leaves at most one file behind.
constexpr int kTemporaryNames = 100;

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
    default:
      return "check the disk or choose another directory";
  }
}

[[noreturn]] void fail(const fs::path& path, int error) {
  throw std::runtime_error("cannot write " + path.string() + ": " + std::strerror(error) + "; " +
                           advice_for(error));
}

fs::path directory_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// Owner of a file descriptor. close() returns the result of the system call.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  int close() { return ::close(std::exchange(fd_, -1)); }

 private:
  int fd_;
};

/// Creates a new file, stores its name in `temporary` and returns its descriptor, or -1.
int create_temporary(const fs::path& path, fs::path& temporary) {
  for (int i = 0; i < kTemporaryNames; ++i) {
    const std::string name = "." + path.filename().string() + ".tmp" + std::to_string(i);
    temporary = directory_of(path) / name;
    const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return fd;
  }
  return -1;
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

bool flush_directory(const fs::path& directory) {
  Descriptor fd(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return fd.get() >= 0 && ::fsync(fd.get()) == 0;
}

}  // namespace

StagedFile::StagedFile(fs::path path, const std::string& bytes) : path_(std::move(path)) {
  Descriptor fd(create_temporary(path_, temporary_));
  if (fd.get() < 0) fail(path_, errno);
  const bool whole = write_all(fd.get(), bytes) && has_size(fd.get(), bytes.size()) &&
                     ::fsync(fd.get()) == 0 && fd.close() == 0;
  if (whole) return;
  const int error = errno;
  ::unlink(temporary_.c_str());
  fail(path_, error);
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : path_(std::move(other.path_)), temporary_(std::exchange(other.temporary_, fs::path())) {}

StagedFile::~StagedFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void StagedFile::commit() {
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_, errno);
  temporary_.clear();
  if (!flush_directory(directory_of(path_))) fail(path_, errno);
}

void write_file_atomically(const fs::path& path, const std::string& bytes) {
  StagedFile(path, bytes).commit();
}

void create_directory_for_files(const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) fail(directory, error.value());
}

}  // namespace ribbon_mapper
