// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/preset_proposal.hpp"

#include <gmock/gmock.h>
#include <ros/time.h>

#include <fstream>

#include "modeler/ros/offline/offline_run.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;

/// A recording of a laser that the PR2's preset was not made for.
class PresetProposal : public testing::TestWithParam<const char*> {
 protected:
  PresetProposal() { ros::Time::init(); }

  OfflineSummary modelled(const fs::path& preset = {}) const {
    OfflineOptions options;
    options.bags = {bag_};
    options.config = preset;
    return model_bags(options, [](const Progress&) {}).summary;
  }

  fs::path bag_ = PROJECT_DIR "/test/data/recordings" / fs::path(GetParam());
};

TEST_P(PresetProposal, GivesABetterModelThanTheDefaults) {
  const TemporaryDirectory directory;
  const fs::path preset = directory.path() / "preset.yaml";
  std::ofstream(preset) << proposed_preset({bag_}, {}, {});
  const OfflineSummary without = modelled(), with = modelled(preset);
  EXPECT_GT(with.planes - with.duplicates, without.planes - without.duplicates);
  EXPECT_LE(with.duplicates, without.duplicates);
  EXPECT_LT(*with.residual_m_median, 0.018);
}

TEST(RealRecordings, PlanesThatStandTwiceAreHintedAt) {
  ros::Time::init();
  OfflineOptions options;
  options.bags = {PROJECT_DIR "/test/data/recordings/room_scan1.bag"};
  const auto text = [&] {
    return summary_text(model_bags(options, [](const Progress&) {}).summary);
  };
  EXPECT_THAT(text(),
              testing::ContainsRegex("of [0-9]+ planes, [0-9]+ may stand twice: bag_check"));
  options.config = PROJECT_DIR "/config/room_scan.yaml";
  EXPECT_THAT(text(), testing::Not(testing::HasSubstr("stand twice")));
}

INSTANTIATE_TEST_SUITE_P(RealRecordings, PresetProposal,
                         testing::Values("room_240.bag", "room_scan1.bag"));

}  // namespace
}  // namespace ribbon_mapper
