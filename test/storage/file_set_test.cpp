// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/storage/file_set.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <map>

#include "test/io/temporary_directory.hpp"
#include "test/storage/full_disk.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// The files of a set by their names.
using Files = std::map<std::string, std::string>;

/// Writes files as a set in a directory.
void write(const fs::path& directory, const Files& files) {
  FileSet set(directory, "set");
  for (const auto& [name, bytes] : files) set.add(name, bytes);
  set.commit();
}

/// Returns what a user finds in a directory: names that can be opened, with their bytes.
Files found_in(const fs::path& directory) {
  Files files;
  for (const auto& entry : fs::directory_iterator(directory)) {
    if (fs::is_regular_file(entry.status())) {
      files[entry.path().filename().string()] = content_of(entry.path());
    }
  }
  return files;
}

/// Returns the names in the set's own folder.
std::vector<std::string> own_names(const fs::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory / ".set.set")) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

const Files kOld{{"a", "old a"}, {"b", "old b"}}, kNew{{"a", "new a"}, {"b", "new b"}};

TEST(FileSet, WritesFilesUnderTheirNames) {
  const TemporaryDirectory directory;
  FileSet set(directory.path() / "below", "set");
  set.add("a", "1"), set.add("b", std::string("2\0", 2));
  EXPECT_TRUE(found_in(directory.path() / "below").empty());
  EXPECT_EQ(set.commit(), (std::vector<fs::path>{directory.path() / "below" / "a",
                                                 directory.path() / "below" / "b"}));
  EXPECT_EQ(found_in(directory.path() / "below"),
            (Files{{"a", "1"}, {"b", std::string("2\0", 2)}}));
}

TEST(FileSet, ReplacesAllFilesAndKeepsOneFolder) {
  const TemporaryDirectory directory;
  for (int i = 0; i < 3; ++i) {
    write(directory.path(), kOld);
    write(directory.path(), kNew);
    EXPECT_EQ(found_in(directory.path()), kNew);
    EXPECT_EQ(own_names(directory.path()).size(), 2U);  // the folder, and the link to it
  }
}

TEST(FileSet, WithoutCommitTheOldFilesStay) {
  const TemporaryDirectory directory;
  { FileSet(directory.path(), "set").add("a", "never seen"); }
  EXPECT_EQ(directory.file_count(), 0U);
  write(directory.path(), kOld);
  { FileSet(directory.path(), "set").add("a", "never seen"); }
  EXPECT_EQ(found_in(directory.path()), kOld);
  EXPECT_EQ(own_names(directory.path()).size(), 2U);
}

TEST(FileSet, MayBeWrittenAgainAsSoonAsItIsCommitted) {
  const TemporaryDirectory directory;
  FileSet set(directory.path(), "set");
  set.add("a", "old a");
  set.commit();
  write(directory.path(), kNew);
  EXPECT_EQ(found_in(directory.path()), kNew);
}

TEST(FileSet, RemovesFilesThatTheNewSetHasNot) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "of the user") << "stays";
  write(directory.path(), kOld);
  write(directory.path(), {{"b", "1"}, {"c", "2"}});
  EXPECT_EQ(found_in(directory.path()), (Files{{"b", "1"}, {"c", "2"}, {"of the user", "stays"}}));
  EXPECT_EQ(directory.file_count(), 4U);
}

TEST(FileSet, ReplacesFilesOfEarlierVersionsAndOfOtherSets) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "a") << "by an earlier version";
  {
    FileSet other(directory.path(), "other");
    other.add("b", "of another set"), other.add("c", "of another set");
    other.commit();
  }
  write(directory.path(), kNew);
  EXPECT_EQ(found_in(directory.path()),
            (Files{{"a", "new a"}, {"b", "new b"}, {"c", "of another set"}}));
}

TEST(FileSet, CanBeCopiedMovedAndWrittenAgain) {
  const TemporaryDirectory directory;
  write(directory.path() / "one", kOld);
  fs::copy(directory.path() / "one", directory.path() / "links",
           fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  fs::copy(directory.path() / "one", directory.path() / "files", fs::copy_options::recursive);
  fs::rename(directory.path() / "one", directory.path() / "moved");
  for (const char* name : {"links", "files", "moved"}) {
    EXPECT_EQ(found_in(directory.path() / name), kOld) << name;
    write(directory.path() / name, kNew);
    EXPECT_EQ(found_in(directory.path() / name), kNew) << name;
    EXPECT_EQ(own_names(directory.path() / name).size(), 2U) << name;
  }
}

TEST(FileSet, ADirectoryInTheWayIsNamedAndTheOldFilesStay) {
  const TemporaryDirectory directory;
  write(directory.path(), kOld);
  fs::create_directory(directory.path() / "c");
  EXPECT_THAT(
      [&] {
        write(directory.path(), {{"a", "1"}, {"c", "2"}});
      },
      ThrowsMessage<std::runtime_error>(HasSubstr((directory.path() / "c").string())));
  EXPECT_EQ(found_in(directory.path()), kOld);
}

TEST(FileSet, AFullDiskAtAnyFileLeavesTheOldFiles) {
  const TemporaryDirectory directory;
  write(directory.path(), kOld);
  const Files larger{{"a", std::string(10, 'x')}, {"b", std::string(20, 'x')}};
  for (rlim_t bytes = 0; bytes < 20; ++bytes) {
    const FullDisk disk(bytes);
    EXPECT_THAT([&] { write(directory.path(), larger); },
                ThrowsMessage<std::runtime_error>(HasSubstr(
                    (directory.path() / (bytes < 10 ? "a" : "b")).string() + ": File too large")));
    EXPECT_EQ(found_in(directory.path()), kOld);
    EXPECT_EQ(own_names(directory.path()).size(), 2U);
  }
  write(directory.path(), larger);
  EXPECT_EQ(found_in(directory.path()), larger);
}

}  // namespace
}  // namespace ribbon_mapper
