// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/series_summary.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "eval/results/summary.hpp"

namespace ribbon_mapper::eval {
namespace {

using testing::HasSubstr;

LoggedRun run(std::uint64_t seed, std::size_t noisy_planes, double drift = 1.0) {
  Summary summary;
  summary.run.seed = seed;
  summary.run.drift = drift;
  summary.metrics.noisy_as_built.planes = noisy_planes;
  summary.metrics.corrected.angle_error_deg_mean = 0.1 * static_cast<double>(seed);
  return parse_run_line(run_line(summary, ""));
}

nlohmann::json distribution(const std::vector<LoggedRun>& runs, const char* key) {
  return nlohmann::json::parse(series_summary_to_json(runs, ""))
      .at("groups")
      .at(0)
      .at("distribution")
      .at(key);
}

TEST(SeriesSummary, MediansAndQuartiles) {
  const auto figures =
      distribution({run(1, 130), run(2, 90), run(3, 110)}, "planes_noisy_as_built");
  EXPECT_EQ(figures.at("min"), 90);
  EXPECT_EQ(figures.at("lower_quartile"), 100);
  EXPECT_EQ(figures.at("median"), 110);
  EXPECT_EQ(figures.at("upper_quartile"), 120);
  EXPECT_EQ(figures.at("max"), 130);
  EXPECT_EQ(distribution({run(1, 1), run(2, 4)}, "four_models.noisy_as_built.planes").at("median"),
            2.5);
}

TEST(SeriesSummary, ARunWithoutAMatchDoesNotCountAsZero) {
  LoggedRun without = run(1, 1);
  without.figures.erase("angle_error_deg_mean");
  EXPECT_NEAR(distribution({run(3, 1), without}, "angle_error_deg_mean").at("min"), 0.3, 1e-12);
}

TEST(SeriesSummary, CountsTheRunsThatAreRight) {
  std::vector<LoggedRun> runs{run(1, 1), run(2, 1), run(3, 1), run(4, 1)};
  runs[0].figures["missed"] = runs[1].figures["extra"] = runs[2].figures["duplicates"] = 1;
  EXPECT_EQ(nlohmann::json::parse(series_summary_to_json(runs, "")).at("right"), 1);
  EXPECT_THAT(series_table_foot(runs, 10), HasSubstr("1 of 4 runs"));
}

TEST(SeriesSummary, RunsOfEqualConditionsAreAGroup) {
  const std::vector<LoggedRun> runs{run(1, 10, 0.5), run(2, 20, 0.5), run(1, 40, 2.0)};
  const auto json = nlohmann::json::parse(series_summary_to_json(runs, "the command"));
  EXPECT_EQ(json.at("command"), "the command");
  EXPECT_FALSE(json.at("version").get<std::string>().empty());
  ASSERT_EQ(json.at("groups").size(), 2U);
  EXPECT_EQ(json.at("groups").at(0).at("drift"), 0.5);
  EXPECT_EQ(json.at("groups").at(0).at("runs"), 2);
  EXPECT_EQ(json.at("groups").at(1).at("distribution").at("planes_noisy_as_built").at("median"),
            40);
  EXPECT_THAT(series_table_foot(runs, 20), HasSubstr("drift 0.5, 2 runs\n"));
}

TEST(SeriesSummary, RowsAreAsWideAsTheHead) {
  const std::string head = series_table_head(20);
  const std::size_t width = series_table_row("seed 7", run(7, 110), 20).size();
  EXPECT_EQ(head.size(), 2 * width) << "two lines";
  EXPECT_EQ(head.find('\n') + 1, width);
  EXPECT_THAT(series_table_row("seed 7", run(7, 110), 20), testing::StartsWith("seed 7 "));
  EXPECT_THAT(series_table_foot({run(7, 110)}, 20), HasSubstr("median"));
}

}  // namespace
}  // namespace ribbon_mapper::eval
