// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment/experiment_options.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <set>

#include "modeler/program/installed_files.hpp"
#include "modeler/program/version.hpp"

namespace ribbon_mapper::eval {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::ThrowsMessage;

std::variant<ExperimentOptions, int> parsed(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "experiment");
  return parse_experiment_options(static_cast<int>(arguments.size()), arguments.data());
}

TEST(ExperimentOptions, WithoutAnyItIsTheApartment) {
  const auto options = std::get<ExperimentOptions>(parsed({}));
  ASSERT_THAT(options.runs, SizeIs(1));
  const RunOptions& run = options.runs.front();
  EXPECT_TRUE(std::filesystem::exists(find_installed_file(run.world))) << run.world;
  EXPECT_TRUE(std::filesystem::exists(route_path(run))) << route_path(run);
  EXPECT_EQ(run.seed, 1U);
  EXPECT_FALSE(run.beams || run.rate_hz || run.speed_m_s || run.deskew);
  EXPECT_FALSE(options.is_series);
}

TEST(ExperimentOptions, AllAreTaken) {
  const auto options = std::get<ExperimentOptions>(
      parsed({"--world",        "w.sdf",   "--route",      "r.yaml", "--seed",      "4",
              "--drift",        "0.5",     "--output",     "out",    "--config",    "c.yaml",
              "--model-path",   "m1",      "--model-path", "m2",     "--noise",     "gazebo",
              "--tilt",         "nav",     "--jobs",       "2",      "--no-figure", "--line",
              "--beams",        "720",     "--speed",      "0.6",    "--deskew",    "off",
              "--mesh-formats", "stl,obj", "--floor-plan", "--rate", "20"}));
  ASSERT_THAT(options.runs, SizeIs(1));
  const RunOptions& run = options.runs.front();
  EXPECT_EQ(route_path(run), "r.yaml");
  EXPECT_EQ(options.output, "out");
  EXPECT_THAT(run.model_paths, testing::IsSupersetOf({"m1", "m2"}));
  EXPECT_EQ(options.jobs, 2U);
  EXPECT_FALSE(options.with_figure);
  EXPECT_TRUE(options.with_floor_plan);
  EXPECT_EQ(options.mesh_formats, (std::vector<MeshFormat>{MeshFormat::stl, MeshFormat::obj}));
  EXPECT_TRUE(options.line_only);
  const std::string command = command_of(run);
  EXPECT_EQ(
      command.substr(0, command.find(" --model-path")),
      "rosrun ribbon_mapper experiment --world w.sdf --route r.yaml --seed 4 --drift 0.5 "
      "--config c.yaml --noise gazebo --tilt nav --beams 720 --rate 20 --speed 0.6 --deskew off");
}

TEST(ExperimentOptions, ListsMakeASeriesOfAllCombinations) {
  const auto options = std::get<ExperimentOptions>(
      parsed({"--world", "a.sdf,b.sdf", "--world", "c.sdf", "--drift", "0,0.5", "--seeds", "3-5",
              "--deskew", "on,off", "--tilt", "manip,nav,slow", "--beams", "380,720,1040",
              "--speed", "0.1,0.6", "--noise", "gazebo,none"}));
  EXPECT_TRUE(options.is_series);
  EXPECT_THAT(options.runs, SizeIs(3 * 2 * 3 * 2 * 3 * 3 * 2 * 2));
  std::set<std::string> commands;
  for (const RunOptions& run : options.runs) commands.insert(command_of(run));
  EXPECT_THAT(commands, SizeIs(options.runs.size())) << "each once";
  EXPECT_THAT(options.command, HasSubstr("--speed 0.1,0.6"));
}

TEST(ExperimentOptions, FaultsOfTheOdometryAreOfOneRun) {
  const auto options = std::get<ExperimentOptions>(
      parsed({"--odometry-faults", "slip=30:20,push=40:2", "--drift", "0"}));
  ASSERT_THAT(options.runs, SizeIs(1));
  EXPECT_THAT(command_of(options.runs.front()),
              HasSubstr("--odometry-faults slip=30:20,push=40:2"));
}

TEST(ExperimentOptions, ASingleSeedOfAListIsASeries) {
  EXPECT_TRUE(std::get<ExperimentOptions>(parsed({"--seeds", "7"})).is_series);
}

using Arguments = std::vector<const char*>;
class WrongUsage : public testing::TestWithParam<std::pair<Arguments, const char*>> {};

TEST_P(WrongUsage, IsExplainedAndEndsWithTwo) {
  testing::internal::CaptureStderr();
  const auto result = parsed(GetParam().first);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr(GetParam().second));
  ASSERT_TRUE(std::holds_alternative<int>(result));
  EXPECT_EQ(std::get<int>(result), 2);
}

INSTANTIATE_TEST_SUITE_P(
    ExperimentOptions, WrongUsage,
    testing::Values(std::pair(Arguments{"--wrold", "x"}, "--wrold"),
                    std::pair(Arguments{"--drift", "-1"}, "--drift"),
                    std::pair(Arguments{"--drift", "x"}, "--drift"),
                    std::pair(Arguments{"--drift", "nan"}, "--drift"),
                    std::pair(Arguments{"--seed", "-3"}, "--seed"),
                    std::pair(Arguments{"--seed", "1", "--seeds", "1-3"}, "--seeds"),
                    std::pair(Arguments{"--seeds", "5-1"}, "1-20"),
                    std::pair(Arguments{"--jobs", "0"}, "--jobs"),
                    std::pair(Arguments{"--noise", "loud"}, "datasheet"),
                    std::pair(Arguments{"--caster", "ode"}, "embree"),
                    std::pair(Arguments{"--tilt", "wild"}, "manip"),
                    std::pair(Arguments{"--tilt", "nav,wild"}, "manip"),
                    std::pair(Arguments{"--drift", "1,-1"}, "--drift"),
                    std::pair(Arguments{"--beams", "1082"}, "--beams"),
                    std::pair(Arguments{"--rate", "41"}, "--rate"),
                    std::pair(Arguments{"--speed", "0"}, "--speed"),
                    std::pair(Arguments{"--deskew", "maybe"}, "--deskew"),
                    std::pair(Arguments{"--odometry-faults", "slip=30"}, "slip=T:DEGREES"),
                    std::pair(Arguments{"--world", "a,b", "--route", "r"}, "--route")));

TEST(ExperimentOptions, HelpEndsWithZero) {
  testing::internal::CaptureStdout();
  const auto result = parsed({"--help"});
  EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("--seeds"));
  EXPECT_EQ(std::get<int>(result), 0);
}

TEST(ExperimentOptions, VersionEndsWithZero) {
  testing::internal::CaptureStdout();
  const auto result = parsed({"--version"});
  EXPECT_EQ(testing::internal::GetCapturedStdout(), version() + "\n");
  EXPECT_EQ(std::get<int>(result), 0);
}

TEST(Seeds, ListsAndRanges) {
  EXPECT_THAT(seeds_from("1-3"), ElementsAre(1U, 2U, 3U));
  EXPECT_THAT(seeds_from("7..9,1"), ElementsAre(1U, 7U, 8U, 9U));
  EXPECT_THAT(seeds_from("2,2,1-2"), ElementsAre(1U, 2U)) << "each once";
}

class BadSeeds : public testing::TestWithParam<const char*> {};

TEST_P(BadSeeds, AreRefusedWithAnExample) {
  EXPECT_THAT([] { seeds_from(GetParam()); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("1-20")));
}

INSTANTIATE_TEST_SUITE_P(Seeds, BadSeeds,
                         testing::Values("", ",", "a", "1-", "-1", "3-1", "1-2-3", "1 2", "1,,2",
                                         "0-999999999999999999", "99999999999999999999"));

}  // namespace
}  // namespace ribbon_mapper::eval
