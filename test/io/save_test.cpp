// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/save.hpp"

#include <gmock/gmock.h>

#include "modeler/surface/surface_config.hpp"
#include "test/io/small_plane.hpp"
#include "test/io/temporary_directory.hpp"
#include "test/storage/full_disk.hpp"

namespace ribbon_mapper {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const double kStripeGap_m = SurfaceConfig{}.stripe_gap_m;

TEST(Save, WritesFourFiles) {
  const TemporaryDirectory directory;
  const auto paths =
      save_model({small_plane()}, directory.path() / "models", "kitchen", kStripeGap_m);
  ASSERT_EQ(paths.size(), 4U);
  for (const auto& path : paths) EXPECT_GT(std::filesystem::file_size(path), 0U) << path;
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "models" / "kitchen.json"));
}

TEST(Save, WritesAPageOfTheSameRun) {
  const TemporaryDirectory directory;
  save_model({small_plane()}, directory.path(), "kitchen", kStripeGap_m, "map",
             {"", {}, [](const std::string& run) { return "run " + run; }});
  const std::string page = content_of(directory.path() / "kitchen.html");
  EXPECT_THAT(content_of(directory.path() / "kitchen.json"), HasSubstr(page.substr(4)));
  EXPECT_EQ(page.size(), 4U + 16U);
}

TEST(Save, WritesRoomsOfTheSameRun) {
  const TemporaryDirectory directory;
  SavedBeside beside;
  beside.rooms = Rooms();
  save_model({small_plane()}, directory.path(), "kitchen", kStripeGap_m, "map", beside);
  const std::string rooms = content_of(directory.path() / "kitchen_rooms.json");
  EXPECT_THAT(rooms, HasSubstr("\"rooms\":[]"));
  const std::string run = rooms.substr(rooms.find("\"run\":\"") + 7, 16);
  EXPECT_THAT(content_of(directory.path() / "kitchen.json"), HasSubstr(run));
}

TEST(Save, AnEmptyModelCanBeSaved) {
  const TemporaryDirectory directory;
  EXPECT_NO_THROW(save_model({}, directory.path(), "empty", kStripeGap_m));
}

class BadName : public testing::TestWithParam<std::string> {};

TEST_P(BadName, IsRefusedAndNothingIsWritten) {
  const TemporaryDirectory directory;
  EXPECT_THAT([&] { save_model({}, directory.path() / "models", GetParam(), kStripeGap_m); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("a name, not a path")));
  EXPECT_EQ(directory.file_count(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Save, BadName,
                         testing::Values("", "a/b", "/etc/passwd", "..", "a..b", ".hidden", "-rf",
                                         "a b", "a\nb", "a\\b", "caf\xc3\xa9",
                                         std::string("a\0b", 3), std::string(65, 'x')));

TEST(Save, GoodNamesAreTaken) {
  for (const char* name : {"a", "_", "Kitchen-2.1", "0"}) EXPECT_NO_THROW(check_save_name(name));
  EXPECT_NO_THROW(check_save_name(std::string(64, 'x')));
}

TEST(Save, AFullDiskLeavesTheEarlierSaveWhole) {
  const TemporaryDirectory directory;
  save_model({small_plane()}, directory.path(), "kitchen", kStripeGap_m);
  const std::string json = content_of(directory.path() / "kitchen.json");

  Plane other = small_plane();
  other.id = 8;
  {
    const FullDisk disk(600);  // enough for the JSON, too little for the mesh
    EXPECT_THROW(save_model({other, small_plane()}, directory.path(), "kitchen", kStripeGap_m),
                 std::runtime_error);
  }
  EXPECT_EQ(content_of(directory.path() / "kitchen.json"), json);
  EXPECT_EQ(directory.file_count(), 5U);  // with the folder of the set
}

/// Returns the word after the first `mark` in a file.
std::string word_after(const std::string& mark, const std::filesystem::path& path) {
  const std::string bytes = content_of(path);
  const std::size_t at = bytes.find(mark);
  if (at == std::string::npos) return "no " + mark;
  return bytes.substr(at + mark.size(),
                      bytes.find_first_of(" \n\"", at + mark.size()) - at - mark.size());
}

TEST(Save, EachFileNamesTheRunAndTheFrame) {
  const TemporaryDirectory directory;
  save_model({small_plane()}, directory.path(), "kitchen", kStripeGap_m, "robot1/map");
  const std::string run = word_after("\"run\": \"", directory.path() / "kitchen.json");
  EXPECT_EQ(run.size(), 16U);
  for (const char* name : {"kitchen.ply", "kitchen_cells.ply", "kitchen.bt"}) {
    EXPECT_EQ(word_after("run ", directory.path() / name), run) << name;
  }
  EXPECT_EQ(word_after("\"frame\": \"", directory.path() / "kitchen.json"), "robot1/map");
  EXPECT_EQ(word_after("ribbon_mapper, ", directory.path() / "kitchen.ply"), "robot1/map");
}

TEST(Save, OnlyTheSameModelHasTheSameRun) {
  const TemporaryDirectory directory;
  Plane other = small_plane();
  other.d_m += 1e-9;
  save_model({small_plane()}, directory.path(), "a", kStripeGap_m);
  save_model({small_plane()}, directory.path(), "b", kStripeGap_m);
  save_model({other}, directory.path(), "c", kStripeGap_m);
  const auto run = [&](const char* name) {
    return word_after("\"run\": \"", directory.path() / name);
  };
  EXPECT_EQ(run("a.json"), run("b.json"));
  EXPECT_NE(run("a.json"), run("c.json"));
}

}  // namespace
}  // namespace ribbon_mapper
