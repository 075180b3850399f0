// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/model_file/autosave.hpp"

#include <gmock/gmock.h>

#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

std::function<std::string()> bytes(const std::string& text) {
  return [text] { return text; };
}

TEST(Autosave, SavesAtOnceAndThenOncePerPeriodIfSomethingChanged) {
  const TemporaryDirectory directory;
  Autosave autosave(directory.path() / "models", 10.0);
  autosave.offer(1, 100.0, bytes("one"));
  EXPECT_EQ("", autosave.finish(1, bytes("never")));  // waits, and has nothing to add
  EXPECT_EQ("one", content_of(autosave.file()));
  autosave.offer(2, 109.0, bytes("early"));
  autosave.offer(1, 110.0, bytes("unchanged"));
  EXPECT_EQ("", autosave.finish(1, bytes("never")));
  EXPECT_EQ("one", content_of(autosave.file()));
  autosave.offer(3, 110.0, bytes("three"));
  EXPECT_EQ("", autosave.finish(3, bytes("never")));
  EXPECT_EQ("three", content_of(autosave.file()));
}

TEST(Autosave, DoesNotSaveWhatIsSaved) {
  const TemporaryDirectory directory;
  Autosave autosave(directory.path(), 1.0);
  autosave.offer(5, 0.0, bytes("five"));
  EXPECT_EQ("", autosave.finish(5, bytes("never")));
  autosave.offer(5, 100.0, bytes("unchanged"));
  EXPECT_EQ("", autosave.finish(5, bytes("never")));
  EXPECT_EQ("five", content_of(autosave.file()));
  EXPECT_EQ("", autosave.finish(6, bytes("six")));
  EXPECT_EQ("six", content_of(autosave.file()));
}

TEST(Autosave, IsOffWithoutAPeriod) {
  const TemporaryDirectory directory;
  Autosave autosave(directory.path() / "models", 0.0);
  autosave.offer(1, 0.0, bytes("one"));
  autosave.finish(2, bytes("two"));
  autosave.begin_another();
  EXPECT_EQ(0u, directory.file_count());
}

TEST(Autosave, SaysOnceWhyItFailed) {
  const TemporaryDirectory directory;
  Autosave autosave(directory.path() / "models", 1.0);
  fs::remove(directory.path() / "models");
  write_content(directory.path() / "models", "in the way");
  EXPECT_EQ("", autosave.offer(1, 0.0, bytes("one")));
  std::string error;
  for (double now_s = 1.0; error.empty() && now_s < 1e6; now_s += 1.0) {
    error = autosave.offer(static_cast<std::size_t>(now_s) + 1, now_s, bytes("more"));
  }
  EXPECT_THAT(error, HasSubstr("cannot write"));
  EXPECT_THAT(autosave.finish(0, bytes("last")), HasSubstr("cannot write"));
}

TEST(Autosave, KeepsThatOfTheModelBefore) {
  const TemporaryDirectory directory;
  Autosave autosave(directory.path(), 100.0);
  autosave.begin_another();  // there is none
  autosave.offer(1, 0.0, bytes("the first model"));
  autosave.begin_another();
  autosave.offer(2, 1.0, bytes("the second model"));
  autosave.finish(2, bytes("never"));
  EXPECT_EQ("the first model", content_of(directory.path() / "autosave_before.ribbons"));
  EXPECT_EQ("the second model", content_of(autosave.file()));
}

TEST(Start, IsTheAutosaveIfItIsThere) {
  const TemporaryDirectory directory;
  const fs::path& folder = directory.path();
  const auto file = [&](const std::string& load, bool resume) {
    return file_to_start_from({folder, load, resume}).value_or("nothing");
  };
  EXPECT_EQ("nothing", file("", true));
  EXPECT_EQ(folder / "kitchen.ribbons", file("kitchen", true));
  write_content(folder / "autosave.ribbons", "");
  EXPECT_EQ(folder / "autosave.ribbons", file("kitchen", true));
  EXPECT_EQ(folder / "kitchen.ribbons", file("kitchen", false));
  EXPECT_EQ("/a/b.ribbons", file("/a/b.ribbons", false));
  EXPECT_EQ("b.ribbons", file("b.ribbons", false));
  EXPECT_EQ("nothing", file("", false));
  EXPECT_THROW(file("..", false), std::invalid_argument);
}

}  // namespace
}  // namespace ribbon_mapper
