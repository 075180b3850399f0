// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// offline_modeler goes on from a model file.
#include <gmock/gmock.h>

#include <fstream>
#include <string>
#include <variant>
#include <vector>

#include "modeler/io/planes_json.hpp"
#include "modeler/ros/offline/offline_run.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;

using testing::Contains;
using testing::HasSubstr;

const fs::path kRoom = PROJECT_DIR "/test/data/small_room.bag";
const fs::path kTruth = PROJECT_DIR "/test/data/small_room.tum";

OfflineRun run(const OfflineOptions& options) {
  ros::Time::init();
  return model_bags(options, [](const Progress&) {});
}

/// Returns a run of the room, at its true poses if they are given.
OfflineRun run_of_room(const fs::path& trajectory = {}) {
  OfflineOptions options;
  options.bags = {kRoom};
  options.config = PROJECT_DIR "/config/pr2.yaml";
  options.trajectory = trajectory;
  return run(options);
}

/// Writes the results of a run and returns options that load its model.
OfflineOptions loading(const OfflineRun& before, const fs::path& folder) {
  write_model(before, folder);
  OfflineOptions options;
  options.load = folder / "model.ribbons";
  return options;
}

TEST(Load, GivesTheModelAgain) {
  const TemporaryDirectory directory;
  const OfflineRun before = run_of_room(kTruth);
  const OfflineRun again = run(loading(before, directory.path()));
  EXPECT_EQ(planes_to_json(before.planes_after), planes_to_json(again.planes_after));
  EXPECT_EQ(before.model_file, again.model_file);
  EXPECT_EQ(again.summary.trajectory, "as corrected in the model that was loaded");
  EXPECT_EQ(again.summary.config, "of model.ribbons");
}

TEST(Load, TakesACorrectionAsIfTheModelHadNeverLeftMemory) {
  const TemporaryDirectory directory;
  OfflineOptions options = loading(run_of_room(), directory.path());
  options.trajectory = kTruth;
  const OfflineRun loaded = run(options), whole = run_of_room(kTruth);
  EXPECT_EQ(planes_to_json(whole.planes_after), planes_to_json(loaded.planes_after));
  EXPECT_EQ(whole.model_file, loaded.model_file);
}

TEST(Load, SaysWhatDiffers) {
  const TemporaryDirectory directory;
  OfflineOptions options = loading(run_of_room(), directory.path());
  options.config = directory.path() / "large.yaml";
  std::ofstream(options.config) << "assembly: {min_area_m2: 500}\n";
  const OfflineRun large = run(options);
  EXPECT_TRUE(large.planes_after.empty());
  EXPECT_THAT(large.summary.notes,
              Contains(HasSubstr("assembly.min_area_m2 was 0.5, is 500: for the whole model")));
}

TEST(Load, RefusesWhatIsNoModel) {
  OfflineOptions options;
  options.load = kRoom;
  try {
    run(options);
    ADD_FAILURE() << "loaded";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("small_room.bag: it is no model file of ribbon_mapper"));
  }
}

TEST(LoadOptions, NeedABagOrAModel) {
  const auto exit_code = [](std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "offline_modeler");
    const auto parsed = parse_offline_options(static_cast<int>(arguments.size()), arguments.data());
    return std::holds_alternative<int>(parsed) ? std::get<int>(parsed) : 0;
  };
  const std::string file = PROJECT_DIR "/test/data/model_format_1.ribbons";
  EXPECT_EQ(exit_code({"--load", file.c_str()}), 0);
  EXPECT_EQ(exit_code({}), 2);
  EXPECT_EQ(exit_code({"--load", "/no/such.ribbons"}), 2);
  EXPECT_EQ(exit_code({"--load", file.c_str(), "--trajectory", "self"}), 2);
}

}  // namespace
}  // namespace ribbon_mapper
