// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "modeler/ros/offline/offline_run.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::filesystem::path kRoom = PROJECT_DIR "/test/data/small_room.bag";

TEST(EmptyModel, AModelWithoutPlanesSaysWhy) {
  ros::Time::init();
  const TemporaryDirectory directory;
  OfflineOptions options;
  options.bags = {kRoom};
  options.config = directory.path() / "large.yaml";
  std::ofstream(options.config) << "assembly: {min_area_m2: 500}\n";
  const OfflineRun found = model_bags(options, [](const Progress&) {});
  EXPECT_TRUE(found.planes_after.empty());
  EXPECT_THAT(summary_text(found.summary),
              ContainsRegex("WARNING no plane: [0-9]+ ribbons, but they"));
  EXPECT_THAT(summary_to_json(found.summary, "run"), HasSubstr("assembly.min_area_m2 (500 m2)"));
  EXPECT_THAT(summary_to_json(found.summary, "run"), HasSubstr("\"assembly.min_area_m2\": 500"));
}

TEST(EmptyModel, ABagWhoseLinesGiveNothingIsAnErrorWithTheCause) {
  ros::Time::init();
  const TemporaryDirectory directory;
  OfflineOptions options;
  options.bags = {kRoom};
  options.config = directory.path() / "near.yaml";
  std::ofstream(options.config) << "scan: {max_range_m: 0.4}\n";
  EXPECT_THAT(
      [&] { model_bags(options, [](const Progress&) {}); },
      ThrowsMessage<std::runtime_error>(
          AllOf(HasSubstr("480 x no returns"), HasSubstr("scan.min_range_m .. scan.max_range_m"))));
}

TEST(EmptyModel, ABagThatTheLoadedModelHasAlreadyIsAnError) {
  ros::Time::init();
  const TemporaryDirectory directory;
  OfflineOptions options;
  options.bags = {kRoom};
  const OfflineRun found = model_bags(options, [](const Progress&) {});
  options.load = directory.path() / "model.ribbons";
  std::ofstream(options.load, std::ios::binary) << found.model_file;
  EXPECT_THAT([&] { model_bags(options, [](const Progress&) {}); },
              ThrowsMessage<std::runtime_error>(
                  AllOf(HasSubstr("the bags add nothing to the model that was loaded"),
                        HasSubstr("475 x older than the loaded model"))));
  options.bags.clear();
  EXPECT_EQ(model_bags(options, [](const Progress&) {}).planes_after.size(),
            found.planes_after.size());
}

}  // namespace
}  // namespace ribbon_mapper
