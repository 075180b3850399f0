// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/storage/atomic_file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>

#include <thread>
#include <vector>

#include "modeler/storage/disk.hpp"
#include "test/io/temporary_directory.hpp"
#include "test/storage/full_disk.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

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

/// A hundred of them once ended saving.
TEST(AtomicFile, LeftoversOfCrashesAreRemoved) {
  const TemporaryDirectory directory;
  for (int i = 0; i < 100; ++i) {
    std::ofstream(directory.path() / (".file.tmp" + std::to_string(i))) << "half, and longer";
  }
  write_file_atomically(directory.path() / "file", "new");
  EXPECT_EQ(content_of(directory.path() / "file"), "new");
  EXPECT_EQ(directory.file_count(), 1U);
}

TEST(AtomicFile, TheTemporaryFileOfAnotherProcessIsLeftAlone) {
  const TemporaryDirectory directory;
  const fs::path temporary = directory.path() / ".file.tmp0";
  const Descriptor of_another = open_locked(temporary, O_WRONLY | O_CREAT);
  ASSERT_TRUE(of_another.is_open());
  write_file_atomically(directory.path() / "file", "new");
  EXPECT_EQ(content_of(directory.path() / "file"), "new");
  EXPECT_TRUE(fs::exists(temporary));
}

TEST(AtomicFile, OfSeveralWritersOneWinsAndNothingIsLeft) {
  const TemporaryDirectory directory;
  std::vector<std::thread> writers;
  for (const char byte : {'a', 'b', 'c', 'd'}) {
    writers.emplace_back([&directory, byte] {
      for (int i = 0; i < 25; ++i) {
        write_file_atomically(directory.path() / "file", std::string(1000, byte));
      }
    });
  }
  for (std::thread& writer : writers) writer.join();
  const std::string content = content_of(directory.path() / "file");
  EXPECT_EQ(content, std::string(1000, content.at(0)));
  EXPECT_EQ(directory.file_count(), 1U);
}

TEST(AtomicFile, NamesTheMissingDirectory) {
  EXPECT_THAT([] { write_file_atomically("/nowhere/file", "x"); },
              ThrowsMessage<std::runtime_error>(
                  AllOf(HasSubstr("/nowhere/file"), HasSubstr("No such file or directory"))));
  EXPECT_THAT([] { create_directory_for_files(""); },
              ThrowsMessage<std::runtime_error>(HasSubstr("directory is empty: name one")));
}

TEST(AtomicFile, AFileInTheWayOfADirectoryIsReported) {
  const TemporaryDirectory directory;
  write_file_atomically(directory.path() / "file", "x");
  EXPECT_THROW(create_directory_for_files(directory.path() / "file" / "below"), std::runtime_error);
  EXPECT_NO_THROW(create_directory_for_files(directory.path() / "a" / "b"));
  EXPECT_NO_THROW(create_directory_for_files(directory.path() / "a" / "b"));
}

TEST(OutputDirectory, RemovesWhatItHasCreatedAndNobodyHasWrittenTo) {
  const TemporaryDirectory directory;
  create_directory_for_files(directory.path() / "old");
  for (const char* name : {"old", "old/a", "new/a/b/", "new/../c"}) {
    const OutputDirectory output(directory.path() / name);
    EXPECT_TRUE(fs::is_directory(directory.path() / name));
  }
  EXPECT_TRUE(fs::is_directory(directory.path() / "old"));
  EXPECT_EQ(directory.file_count(), 1U);
  {
    const OutputDirectory output(directory.path() / "new/a/b");
    write_file_atomically(directory.path() / "new/a/file", "x");
  }
  EXPECT_TRUE(fs::exists(directory.path() / "new/a/file"));
  EXPECT_FALSE(fs::exists(directory.path() / "new/a/b"));
}

}  // namespace
}  // namespace ribbon_mapper
