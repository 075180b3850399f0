// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/run_log.hpp"

#include <gmock/gmock.h>

#include "eval/results/summary.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper::eval {
namespace {

using testing::HasSubstr;

RunOptions run(double drift, std::uint64_t seed) {
  RunOptions options;
  options.drift = drift;
  options.seed = seed;
  return options;
}

std::string line_of(const RunOptions& options, const std::string& inputs = "in") {
  Summary summary;
  summary.run = with_portable_names(options);
  summary.lines = options.seed;
  return run_line(summary, inputs);
}

class Log : public testing::Test {
 protected:
  TemporaryDirectory directory_;
  std::filesystem::path path_ = directory_.path() / "runs.jsonl";
};

TEST_F(Log, ALineHoldsItsRunAndItsFigures) {
  RunOptions options = run(0.5, 7);
  options.beams = 720;
  options.rate_hz = 20.0;
  options.deskew = false;
  options.odometry_faults = "push=30:2";
  const LoggedRun logged = parse_run_line(line_of(options));
  EXPECT_FALSE(comes_before(logged.run, with_portable_names(options)));
  EXPECT_FALSE(comes_before(with_portable_names(options), logged.run));
  EXPECT_EQ(logged.run.odometry_faults, "push=30:2");
  EXPECT_EQ(logged.figures.at("lines"), 7.0);
  EXPECT_EQ(logged.figures.at("four_models.noisy_as_built.planes"), 0.0);
  EXPECT_EQ(logged.figures.count("seed"), 0U);
  EXPECT_EQ(logged.figures.count("angle_error_deg_mean"), 0U) << "null";
}

// A series may be killed in the middle of a line.
TEST_F(Log, AnInterruptedSeriesEndsInTheSameBytes) {
  const std::vector<RunOptions> runs{run(0.0, 1), run(0.0, 2), run(2.0, 1), run(10.0, 1)};
  {
    RunLog whole(path_);
    for (const RunOptions& one : runs) whole.append(line_of(one));
    whole.sort();
  }
  const std::string uninterrupted = content_of(path_);
  write_content(path_, line_of(runs[3]) + line_of(runs[1]) + line_of(runs[2]).substr(0, 40));
  RunLog resumed(path_);
  EXPECT_TRUE(resumed.has(runs[1], "in"));
  EXPECT_TRUE(resumed.has(runs[3], "in"));
  EXPECT_FALSE(resumed.has(runs[2], "in")) << "its line was cut off";
  for (const RunOptions& one : {runs[2], runs[0]}) resumed.append(line_of(one));
  resumed.sort();
  EXPECT_EQ(content_of(path_), uninterrupted);
}

TEST_F(Log, ReturnsTheRequestedRunsSorted) {
  RunLog log(path_);
  for (const double drift : {10.0, 2.0, 0.0}) log.append(line_of(run(drift, 1)));
  const auto runs = log.logged_runs({run(10.0, 1), run(2.0, 1), run(5.0, 1)});
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].run.drift, 2.0);
  EXPECT_EQ(runs[1].run.drift, 10.0);
}

TEST_F(Log, ChangedInputsAreRefused) {
  RunLog log(path_);
  log.append(line_of(run(1.0, 1), "as it was"));
  EXPECT_THAT([&] { log.has(run(1.0, 1), "otherwise"); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("has changed")));
}

TEST_F(Log, OtherContentIsRefusedWithItsLine) {
  write_content(path_, line_of(run(1.0, 1)) + "{\"a\": 1}\n");
  EXPECT_THAT([&] { RunLog log(path_); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("line 2")));
  std::string other = line_of(run(1.0, 1));
  other.replace(other.find("\"version\":\"") + 11, 1, "9");
  write_content(path_, other);
  EXPECT_THAT([&] { RunLog log(path_); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("--output")));
}

TEST_F(Log, RunsThatLackAKeyAreRefused) {
  for (const std::string key : {"lines", "four_models"}) {
    std::string line = line_of(run(1.0, 1));
    line.replace(line.find("\"" + key + "\":"), 1, "\"former_");
    write_content(path_, line);
    EXPECT_THAT([&] { RunLog log(path_); },
                testing::ThrowsMessage<std::runtime_error>(HasSubstr("has no '" + key + "'")));
  }
}

TEST_F(Log, AFolderThatIsNotThereIsNamed) {
  RunLog log("/nowhere/runs.jsonl");
  EXPECT_THAT([&] { log.append(line_of(run(1.0, 1))); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("/nowhere")));
}

}  // namespace
}  // namespace ribbon_mapper::eval
