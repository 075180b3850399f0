// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/spread.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace ribbon_mapper::eval {
namespace {

using testing::HasSubstr;

Summary run(std::uint64_t seed, std::size_t noisy_planes) {
  Summary summary;
  summary.seed = seed;
  summary.cells.noisy_raw.planes = noisy_planes;
  summary.cells.corrected_merged.angle_error_deg_mean = 0.1 * static_cast<double>(seed);
  return summary;
}

nlohmann::json spread(const std::vector<Summary>& runs, const char* key) {
  return nlohmann::json::parse(spread_to_json(runs)).at("spread").at(key);
}

TEST(Spread, MedianOfAnOddAndOfAnEvenNumberOfRuns) {
  const std::vector<Summary> three{run(1, 130), run(2, 90), run(3, 110)};
  EXPECT_EQ(spread(three, "planes_noisy_raw").at("least"), 90);
  EXPECT_EQ(spread(three, "planes_noisy_raw").at("median"), 110);
  EXPECT_EQ(spread(three, "planes_noisy_raw").at("most"), 130);
  EXPECT_EQ(spread({three[0], three[1]}, "planes_noisy_raw").at("median"), 110);
  EXPECT_EQ(spread({three[0], three[2]}, "planes_noisy_raw").at("median"), 120);
}

TEST(Spread, ARunWithoutAMatchDoesNotCountAsZero) {
  Summary without = run(1, 1);
  without.cells.corrected_merged.angle_error_deg_mean.reset();
  EXPECT_NEAR(spread({without, run(3, 1)}, "angle_error_deg_mean").at("least"), 0.3, 1e-12);
  EXPECT_TRUE(spread({without}, "angle_error_deg_mean").at("median").is_null());
}

TEST(Spread, CountsTheRunsThatAreRight) {
  std::vector<Summary> runs{run(1, 1), run(2, 1), run(3, 1), run(4, 1)};
  runs[0].cells.corrected_merged.missed = {3};
  runs[1].cells.corrected_merged.extra = {3};
  runs[2].cells.corrected_merged.duplicates = {3};
  EXPECT_EQ(nlohmann::json::parse(spread_to_json(runs)).at("right"), 1);
  EXPECT_THAT(spread_foot(runs), HasSubstr("1 of 4 runs"));
}

TEST(Spread, RowsStandUnderTheHead) {
  const std::size_t width = spread_head().size();
  EXPECT_EQ(spread_row(run(7, 110)).size(), width);
  EXPECT_THAT(spread_row(run(7, 110)), testing::StartsWith("7 "));
  EXPECT_THAT(spread_foot({run(7, 110)}), HasSubstr("median"));
}

}  // namespace
}  // namespace ribbon_mapper::eval
