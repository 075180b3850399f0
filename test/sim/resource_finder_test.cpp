// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sdf/resource_finder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {
namespace {

TEST(ResourceFinder, LooksBesideTheFileThenInTheFoldersInOrder) {
  const TemporaryDirectory directory;
  const auto at = [&](const std::string& name) { return (directory.path() / name).string(); };
  write_file(at("b/chair/model.sdf"), "");
  EXPECT_EQ(find_resource("model://chair", at("base"), {at("a"), at("b")}), at("b/chair"));
  write_file(at("a/chair/model.sdf"), "");
  EXPECT_EQ(find_resource("model://chair", at("base"), {at("a"), at("b")}), at("a/chair"));
  write_file(at("base/chair/model.sdf"), "");
  EXPECT_EQ(find_resource("model://chair", at("base"), {at("a"), at("b")}), at("base/chair"));
  EXPECT_EQ(find_resource("chair/model.sdf", at("base"), {}), at("base/chair/model.sdf"));
  EXPECT_EQ(find_resource("model://table", at("base"), {at("a"), at("b")}), "");
}

TEST(ResourceFinder, TakesAbsolutePathsAsTheyAre) {
  const TemporaryDirectory directory;
  const std::string file = (directory.path() / "lamp.dae").string();
  EXPECT_EQ(find_resource("file://" + file, "/nowhere", {}), "") << "not there yet";
  write_file(file, "");
  EXPECT_EQ(find_resource("file://" + file, "/nowhere", {}), file);
  EXPECT_EQ(find_resource(file, "/nowhere", {}), file);
  EXPECT_EQ(find_resource("", directory.path().string(), {}), "");
  EXPECT_EQ(find_resource("model://", directory.path().string(), {}), "");
}

TEST(ResourceFinder, SplitsPathLists) {
  EXPECT_THAT(split_path_list("/a:/b c:/d"), testing::ElementsAre("/a", "/b c", "/d"));
  EXPECT_THAT(split_path_list("::/a::"), testing::ElementsAre("/a"));
  EXPECT_THAT(split_path_list(""), testing::IsEmpty());
}

}  // namespace
}  // namespace ribbon_mapper::sim
