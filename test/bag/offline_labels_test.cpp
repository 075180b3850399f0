// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "modeler/ros/offline/offline_run.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

TEST(OfflineLabels, PlanesHaveLabelsAndTheRoomIsOne) {
  const TemporaryDirectory directory;
  ros::Time::init();
  OfflineOptions options;
  options.bags = {PROJECT_DIR "/test/data/small_room.bag"};
  options.config = PROJECT_DIR "/config/pr2.yaml";
  write_model(model_bags(options, [](const Progress&) {}), directory.path());
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

}  // namespace
}  // namespace ribbon_mapper
