// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/atomic_file.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>

#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Limits the size of files during its lifetime, as a full disk does.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

TEST(AtomicFile, WritesEveryByte) {
  const TemporaryDirectory directory;
  const std::string bytes("one\0two\n", 8);
  write_file_atomically(directory.path() / "file", bytes);
  EXPECT_EQ(content_of(directory.path() / "file"), bytes);
  EXPECT_EQ(directory.file_count(), 1U);
}

TEST(AtomicFile, ReplacesAnOlderFile) {
  const TemporaryDirectory directory;
  write_file_atomically(directory.path() / "file", "old and longer");
  write_file_atomically(directory.path() / "file", "new");
  EXPECT_EQ(content_of(directory.path() / "file"), "new");
}

TEST(AtomicFile, WithoutCommitTheOldFileStays) {
  const TemporaryDirectory directory;
  write_file_atomically(directory.path() / "file", "old");
  { const StagedFile staged(directory.path() / "file", "new"); }
  EXPECT_EQ(content_of(directory.path() / "file"), "old");
  EXPECT_EQ(directory.file_count(), 1U);
}

TEST(AtomicFile, FullDiskIsReportedAndLeavesTheOldFileWhole) {
  const TemporaryDirectory directory;
  write_file_atomically(directory.path() / "file", "old");
  {
    const FullDisk disk(1000);
    EXPECT_THAT([&] { write_file_atomically(directory.path() / "file", std::string(5000, 'x')); },
                ThrowsMessage<std::runtime_error>(
                    AllOf(HasSubstr((directory.path() / "file").string()),
                          HasSubstr("File too large"), HasSubstr("choose another directory"))));
  }
  EXPECT_EQ(content_of(directory.path() / "file"), "old");
  EXPECT_EQ(directory.file_count(), 1U);
}

TEST(AtomicFile, LeftoversOfACrashDoNotMatter) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / ".file.tmp0") << "half";
  write_file_atomically(directory.path() / "file", "new");
  EXPECT_EQ(content_of(directory.path() / "file"), "new");
}

TEST(AtomicFile, NamesTheMissingDirectory) {
  EXPECT_THAT([] { write_file_atomically("/nowhere/file", "x"); },
              ThrowsMessage<std::runtime_error>(
                  AllOf(HasSubstr("/nowhere/file"), HasSubstr("No such file or directory"))));
}

TEST(AtomicFile, AFileInTheWayOfADirectoryIsReported) {
  const TemporaryDirectory directory;
  write_file_atomically(directory.path() / "file", "x");
  EXPECT_THROW(create_directory_for_files(directory.path() / "file" / "below"), std::runtime_error);
  EXPECT_NO_THROW(create_directory_for_files(directory.path() / "a" / "b"));
  EXPECT_NO_THROW(create_directory_for_files(directory.path() / "a" / "b"));
}

}  // namespace
}  // namespace ribbon_mapper
