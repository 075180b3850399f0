// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/storage/file_set.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

#include "modeler/storage/atomic_file.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCurrent = "current";  // the link to the folder of the present files
constexpr const char* kNewLink = "link";     // a link before it is renamed
constexpr std::chrono::seconds kPatience{10};

void create_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail_to_write(folder, error.value());
}

/// Creates the set's own folder and locks it.
Descriptor locked_folder(const fs::path& folder) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (true) {
    create_folder(folder);
    Descriptor lock = open_locked(folder, O_RDONLY | O_DIRECTORY);
    if (lock.is_open()) return lock;
    const bool may_come = errno == EWOULDBLOCK || errno == ENOENT;  // ENOENT: removed meanwhile
    if (!may_come || std::chrono::steady_clock::now() > end) {
      fail_to_write(folder, errno);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

/// Returns where a symbolic link leads to; empty if `path` is none.
fs::path target_of(const fs::path& path) {
  std::error_code error;
  return fs::read_symlink(path, error);
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Returns the name of a folder that is not there yet.
std::string new_name_in(const fs::path& folder) {
  int number = 1;
  while (fs::exists(fs::symlink_status(folder / std::to_string(number)))) ++number;
  return std::to_string(number);
}

}  // namespace

FileSet::FileSet(fs::path directory, const std::string& name)
    : directory_(std::move(directory)), set_("." + name + ".set") {
  create_directory_for_files(directory_);
  lock_ = locked_folder(directory_ / set_);
  remove_leftovers();
  folder_ = own_folder() / new_name_in(own_folder());
  create_folder(folder_);
}

FileSet::FileSet(FileSet&& other) noexcept
    : directory_(std::move(other.directory_)),
      set_(std::move(other.set_)),
      lock_(std::move(other.lock_)),
      folder_(std::exchange(other.folder_, fs::path())) {}

FileSet::~FileSet() {
  if (!folder_.empty()) remove_leftovers();
  release();
}

void FileSet::add(const std::string& file, const std::string& bytes) {
  const Descriptor fd(
      ::open((folder_ / file).c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (!fd.is_open() || !write_flushed(fd.get(), bytes)) {
    fail_to_write(directory_ / file, errno);
  }
}

std::vector<fs::path> FileSet::commit() {
  const std::vector<std::string> files = names_in(folder_);
  for (const std::string& file : files) flush(folder_ / file);
  flush(folder_);
  if (has_links()) {
    for (const std::string& file : files) place_link(file);
    replace_link(folder_.filename(), own_folder() / kCurrent);  // the commit
    flush(own_folder());
  } else {
    for (const std::string& file : files) rename_into_place(file);
  }
  folder_.clear();
  remove_leftovers();
  flush(directory_);
  std::vector<fs::path> paths;
  for (const std::string& file : files) {
    remove_leftovers_of(directory_ / file);
    paths.push_back(directory_ / file);
  }
  release();
  return paths;
}

/// Lets other processes write the set, and removes its own folder if that is empty.
void FileSet::release() {
  if (!lock_.is_open()) return;
  ::rmdir(own_folder().c_str());  // fails if there are files
  lock_ = Descriptor();
}

/// Returns where the link to a file leads.
fs::path FileSet::target_for(const std::string& file) const {
  return fs::path(set_) / kCurrent / file;
}

/// Returns whether the disk has symbolic links.
bool FileSet::has_links() const {
  const fs::path link = own_folder() / kNewLink;
  if (::symlink(kCurrent, link.c_str()) == 0) return ::unlink(link.c_str()) == 0;
  if (errno == EPERM || errno == ENOSYS || errno == EOPNOTSUPP) return false;
  fail_to_write(link, errno);
}

/// Makes the name of a file a link. Whoever opens it still finds the old file, or none.
void FileSet::place_link(const std::string& file) {
  const fs::path visible = directory_ / file;
  if (target_of(visible) == target_for(file)) return;
  if (fs::is_directory(visible)) fail_to_write(visible, EISDIR);
  if (fs::exists(visible)) adopt(file);
  replace_link(target_for(file), visible);
}

/// Keeps an old file that is not of this set, such as that of an earlier version, where its link
/// will lead until the commit.
void FileSet::adopt(const std::string& file) {
  const fs::path current = own_folder() / kCurrent;
  if (!fs::is_directory(current)) {
    const std::string name = new_name_in(own_folder());
    create_folder(own_folder() / name);
    replace_link(name, current);
  }
  std::error_code error;
  const fs::path source = fs::canonical(directory_ / file, error);
  fs::remove(current / file, error);
  fs::create_hard_link(source, current / file, error);
  if (error) fs::copy_file(source, current / file, error);
  if (error) fail_to_write(current / file, error.value());
}

void FileSet::replace_link(const fs::path& target, const fs::path& link) {
  const fs::path temporary = own_folder() / kNewLink;
  ::unlink(temporary.c_str());
  if (::symlink(target.c_str(), temporary.c_str()) != 0 ||
      ::rename(temporary.c_str(), link.c_str()) != 0) {
    fail_to_write(link, errno);
  }
}

void FileSet::rename_into_place(const std::string& file) {
  const fs::path visible = directory_ / file;
  if (::rename((folder_ / file).c_str(), visible.c_str()) != 0) {
    fail_to_write(visible, errno);
  }
}

/// Removes all folders but that of the present files, and links to files that are not there.
void FileSet::remove_leftovers() {
  const std::string current = target_of(own_folder() / kCurrent).string();
  std::error_code error;
  for (const std::string& name : names_in(own_folder())) {
    // A copy that followed links has made a folder of `current`, and files of the links to it.
    const bool is_needed = !current.empty() && (name == kCurrent || name == current);
    if (!is_needed) fs::remove_all(own_folder() / name, error);
  }
  for (const std::string& name : names_in(directory_)) {
    const fs::path visible = directory_ / name;
    if (target_of(visible) == target_for(name) && !fs::exists(visible, error)) {
      fs::remove(visible, error);
    }
  }
}

}  // namespace ribbon_mapper
