// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment/run_options.hpp"

#include <gmock/gmock.h>

#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper::eval {
namespace {

using testing::HasSubstr;

TEST(RunOptions, TheRouteIsBesideTheWorld) {
  RunOptions run;
  run.world = "my/flat.world";
  EXPECT_EQ(route_path(run), "my/flat.route.yaml");
}

TEST(RunOptions, ACommandSurvivesTheShell) {
  RunOptions run;
  run.world = "my flat.sdf";
  EXPECT_THAT(command_of(run), HasSubstr("--world 'my flat.sdf' --seed 1"));
}

TEST(RunOptions, SortByConditionsThenSeed) {
  RunOptions a, b;
  a.drift = 2.0, a.seed = 1;
  b.drift = 10.0, b.seed = 0;
  EXPECT_TRUE(comes_before(a, b)) << "as numbers";
  EXPECT_FALSE(is_repetition(a, b));
  b.drift = 2.0;
  EXPECT_TRUE(comes_before(b, a));
  EXPECT_TRUE(is_repetition(a, b));
}

TEST(RunOptions, LabelsSayWhatDiffers) {
  RunOptions a, b;
  b.drift = 0.5, b.deskew = false, b.seed = 4;
  EXPECT_EQ(label_of(b, {a, b}), "deskew off, drift 0.5, seed 4");
  EXPECT_EQ(label_of(b, {b, b}), "seed 4");
}

TEST(RunOptions, TheFingerprintFollowsTheContents) {
  const TemporaryDirectory directory;
  RunOptions run;
  run.world = (directory.path() / "a.sdf").string();
  run.route = run.config = run.world;
  EXPECT_THAT([&] { inputs_of(run); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("a.sdf")));
  write_content(run.world, "one");
  const std::string first = inputs_of(run);
  EXPECT_EQ(inputs_of(run), first);
  write_content(run.world, "two");
  EXPECT_NE(inputs_of(run), first);
}

}  // namespace
}  // namespace ribbon_mapper::eval
