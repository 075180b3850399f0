// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "modeler/ros/offline/offline_run.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

OfflineRun small_room(const std::string& preset) {
  ros::Time::init();
  OfflineOptions options;
  options.bags = {PROJECT_DIR "/test/data/small_room.bag"};
  options.config = preset;
  return model_bags(options, [](const Progress&) {});
}

TEST(OfflineLabels, PlanesHaveLabelsAndTheRoomIsOne) {
  const TemporaryDirectory directory;
  write_model(small_room(PROJECT_DIR "/config/pr2.yaml"), directory.path());
  std::size_t floors = 0;
  const auto model = nlohmann::json::parse(content_of(directory.path() / "planes_after.json"));
  for (const auto& plane : model.at("planes")) {
    floors += plane.at("label") == "floor" ? 1 : 0;
  }
  EXPECT_EQ(floors, 1U);
  const auto rooms = nlohmann::json::parse(content_of(directory.path() / "rooms.json"));
  ASSERT_EQ(rooms.at("rooms").size(), 1U);
  EXPECT_EQ(rooms.at("rooms").at(0).at("name"), "A");
  const std::string page = content_of(directory.path() / "report.html");
  EXPECT_NE(page.find("\"room A\""), std::string::npos);
  EXPECT_NE(page.find("\"label\":\"floor\""), std::string::npos);
}

TEST(OfflineLabels, RoomsOfTheFloorPlanAreTheRoomsWhateverThePreset) {
  const TemporaryDirectory directory;
  const auto preset = directory.path() / "close_lines.yaml";
  std::string text = content_of(PROJECT_DIR "/config/pr2.yaml");
  const std::string key = "stripe_gap_m: 0.3";
  ASSERT_NE(text.find(key), std::string::npos);
  std::ofstream(preset) << text.replace(text.find(key), key.size(), "stripe_gap_m: 0.02");
  const OfflineRun run = small_room(preset.string());
  ASSERT_FALSE(run.rooms.rooms.empty());
  const OfflineRun usual = small_room(PROJECT_DIR "/config/pr2.yaml");
  ASSERT_LT(run.rooms.rooms[0].area_m2, usual.rooms.rooms[0].area_m2) << "stripes remain";
  ASSERT_EQ(run.rooms.rooms.size(), run.floor_plan.rooms.size());
  for (std::size_t i = 0; i < run.rooms.rooms.size(); ++i) {
    EXPECT_EQ(run.rooms.rooms[i].area_m2, run.floor_plan.rooms[i].area_m2) << i;
  }
}

}  // namespace
}  // namespace ribbon_mapper
