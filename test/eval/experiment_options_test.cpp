// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment_options.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "eval/share.hpp"

namespace ribbon_mapper::eval {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::variant<ExperimentOptions, int> parsed(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "experiment");
  return parse_experiment_options(static_cast<int>(arguments.size()), arguments.data());
}

TEST(ExperimentOptions, WithoutAnyItIsTheApartment) {
  const auto options = std::get<ExperimentOptions>(parsed({}));
  EXPECT_TRUE(std::filesystem::exists(find_shared(options.world))) << options.world;
  EXPECT_TRUE(std::filesystem::exists(route_path(options))) << route_path(options);
  EXPECT_THAT(options.seeds, ElementsAre(1U));
  EXPECT_FALSE(options.many_seeds);
}

TEST(ExperimentOptions, AllAreTaken) {
  const auto options = std::get<ExperimentOptions>(parsed(
      {"--world",  "w.sdf",  "--route",  "r.yaml", "--seeds",      "3-5", "--drift",      "0.5",
       "--output", "out",    "--config", "c.yaml", "--model-path", "m1",  "--model-path", "m2",
       "--noise",  "gazebo", "--tilt",   "nav",    "--jobs",       "2",   "--no-figure"}));
  EXPECT_EQ(options.world, "w.sdf");
  EXPECT_EQ(route_path(options), "r.yaml");
  EXPECT_THAT(options.seeds, ElementsAre(3U, 4U, 5U));
  EXPECT_TRUE(options.many_seeds);
  EXPECT_EQ(options.drift, 0.5);
  EXPECT_EQ(options.output, "out");
  EXPECT_THAT(options.model_paths, testing::IsSupersetOf({"m1", "m2"}));
  EXPECT_EQ(options.jobs, 2U);
  EXPECT_FALSE(options.with_figure);
  const std::string command = command_of(options, 4);
  EXPECT_EQ(command.substr(0, command.find(" --model-path")),
            "rosrun ribbon_mapper experiment --world w.sdf --route r.yaml --seed 4 --drift 0.5 "
            "--config c.yaml --noise gazebo --tilt nav");
}

TEST(ExperimentOptions, TheRouteIsBesideTheWorld) {
  ExperimentOptions options;
  options.world = "my/flat.world";
  EXPECT_EQ(route_path(options), "my/flat.route.yaml");
}

TEST(ExperimentOptions, ACommandSurvivesTheShell) {
  ExperimentOptions options;
  options.world = "my flat.sdf";
  EXPECT_THAT(command_of(options, 1), HasSubstr("--world 'my flat.sdf' --seed 1"));
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

INSTANTIATE_TEST_SUITE_P(ExperimentOptions, WrongUsage,
                         testing::Values(std::pair(Arguments{"--wrold", "x"}, "--wrold"),
                                         std::pair(Arguments{"--drift", "-1"}, "--drift"),
                                         std::pair(Arguments{"--drift", "x"}, "--drift"),
                                         std::pair(Arguments{"--drift", "nan"}, "--drift"),
                                         std::pair(Arguments{"--seed", "-3"}, "--seed"),
                                         std::pair(Arguments{"--seed", "1", "--seeds", "1-3"},
                                                   "--seeds"),
                                         std::pair(Arguments{"--seeds", "5-1"}, "1-20"),
                                         std::pair(Arguments{"--jobs", "0"}, "--jobs"),
                                         std::pair(Arguments{"--noise", "loud"}, "datasheet"),
                                         std::pair(Arguments{"--tilt", "wild"}, "manip")));

TEST(ExperimentOptions, HelpEndsWithZero) {
  testing::internal::CaptureStdout();
  const auto result = parsed({"--help"});
  EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("--seeds"));
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
