// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/summary.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace ribbon_mapper::eval {
namespace {

using nlohmann::json;

MapMetrics metrics_with(std::size_t planes) {
  MapMetrics m;
  m.planes = planes;
  m.truth = 22;
  return m;
}

/// Returns a summary with distinct numbers, so that swapped values are detected.
Summary sample() {
  Summary s;
  s.command = "experiment --seed 7";
  s.run.world = "flat.sdf";
  s.run.route = "flat.route.yaml";
  s.run.seed = 7;
  s.run.drift = 0.5;
  s.lines = 9000;
  s.dropped_lines = 3;
  s.ribbons = 80000;
  s.metrics = {metrics_with(110), metrics_with(60), metrics_with(31), metrics_with(24)};
  MapMetrics& result = s.metrics.corrected;
  result.matched = 21;
  result.missed = {4};
  result.extra = {1, 9};
  result.duplicates = {0, 2, 5, 6, 8};
  result.precision = 0.875;
  result.recall = 0.954;
  result.f1 = 0.913;
  result.coverage = 0.99;
  result.angle_error_deg_mean = 0.25;
  result.offset_error_m_mean = 0.0075;
  s.end_drift_m = 0.64;
  s.end_drift_deg = 8.5;
  s.us_per_line = 402.0;
  s.correction_ms = 350.0;
  s.real_time_factor = 62.5;
  return s;
}

TEST(SummaryJson, HasEveryKeyWithItsOwnValue) {
  const json j = json::parse(summary_to_json(sample()));
  EXPECT_EQ(j.at("world"), "flat.sdf");
  EXPECT_EQ(j.at("route"), "flat.route.yaml");
  EXPECT_EQ(j.at("command"), "experiment --seed 7");
  const std::map<std::string, double> expected{{"seed", 7},
                                               {"drift", 0.5},
                                               {"lines", 9000},
                                               {"ribbons", 80000},
                                               {"truth_planes", 22},
                                               {"planes_noisy_as_built", 110},
                                               {"planes_noisy", 60},
                                               {"planes_corrected_as_built", 31},
                                               {"planes_corrected", 24},
                                               {"matched", 21},
                                               {"missed", 1},
                                               {"extra", 2},
                                               {"duplicates", 5},
                                               {"precision", 0.875},
                                               {"recall", 0.954},
                                               {"f1", 0.913},
                                               {"coverage", 0.99},
                                               {"angle_error_deg_mean", 0.25},
                                               {"offset_error_m_mean", 0.0075},
                                               {"end_drift_m", 0.64},
                                               {"end_drift_deg", 8.5},
                                               {"us_per_line", 402},
                                               {"correction_ms", 350},
                                               {"real_time_factor", 62.5},
                                               {"dropped_lines", 3}};
  for (const auto& [key, value] : expected) {
    ASSERT_TRUE(j.contains(key)) << key;
    EXPECT_DOUBLE_EQ(j[key].get<double>(), value) << key;
  }
}

TEST(SummaryJson, HoldsTheFourModels) {
  const json models = json::parse(summary_to_json(sample())).at("four_models");
  EXPECT_EQ(models.at("noisy_as_built").at("planes"), 110);
  EXPECT_EQ(models.at("noisy").at("planes"), 60);
  EXPECT_EQ(models.at("corrected_as_built").at("planes"), 31);
  EXPECT_EQ(models.at("corrected").at("duplicates"), 5);
}

PointMetrics points_with(std::size_t correct) {
  PointMetrics p;
  p.segcomp.correct = correct;
  p.segcomp.over = 11;
  p.segcomp.under = 12;
  p.segcomp.missed = {1, 2, 3};
  p.segcomp.noise = {1};
  p.segcomp.correct_points_share = 0.5;
  p.segcomp.correct_share = 0.75;
  p.duplication.duplicates = 13;
  p.evops.f1 = 0.682;
  p.segcomp_all.correct = 2 * correct;
  return p;
}

TEST(SummaryJson, HoldsThePointsOfTheFourModels) {
  Summary s = sample();
  const json without = json::parse(summary_to_json(s)).at("four_models").at("noisy_as_built");
  EXPECT_TRUE(without.at("segcomp").is_null()) << "over ROS";
  s.points = {points_with(1), points_with(2), points_with(3), points_with(4)};
  const json models = json::parse(summary_to_json(s)).at("four_models");
  EXPECT_EQ(models.at("noisy_as_built").at("segcomp").at("correct"), 1);
  EXPECT_EQ(models.at("noisy").at("segcomp").at("correct"), 2);
  EXPECT_EQ(models.at("corrected_as_built").at("segcomp").at("correct"), 3);
  const json result = models.at("corrected");
  EXPECT_EQ(result.at("segcomp").at("correct"), 4);
  EXPECT_EQ(result.at("segcomp").at("over"), 11);
  EXPECT_EQ(result.at("segcomp").at("under"), 12);
  EXPECT_EQ(result.at("segcomp").at("missed"), 3);
  EXPECT_EQ(result.at("segcomp").at("noise"), 1);
  EXPECT_EQ(result.at("point_duplicates"), 13);
  EXPECT_EQ(result.at("segcomp_all").at("correct"), 8);
  EXPECT_EQ(result.at("evops").at("f1"), 0.682);
}

TEST(RunLine, IsTheSummaryWithoutTimes) {
  Summary slow = sample(), fast = sample();
  fast.us_per_line = fast.correction_ms = fast.real_time_factor = 1.0;
  const std::string line = run_line(slow, "abc");
  EXPECT_EQ(line, run_line(fast, "abc"));
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  json whole = json::parse(summary_to_json(slow)), part = json::parse(line);
  EXPECT_EQ(part.at("inputs"), "abc");
  for (const char* key : {"us_per_line", "correction_ms", "real_time_factor"}) {
    EXPECT_NE(timing_line(slow).find(key), std::string::npos);
    whole.erase(key);
  }
  part.erase("inputs");
  EXPECT_EQ(whole, part);
}

TEST(SummaryJson, WithoutAMatchErrorsAreNullNotZero) {
  const json j = json::parse(summary_to_json(Summary()));
  EXPECT_TRUE(j.at("angle_error_deg_mean").is_null());
  EXPECT_TRUE(j.at("offset_error_m_mean").is_null());
}

/// Returns what follows `name` in the line of the table that begins with it, or nothing.
std::string row_of(const std::string& table, const std::string& name) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(name, 0) == 0) return line.substr(name.size());
  }
  return "";
}

std::vector<std::string> words_of(const std::string& row) {
  std::istringstream stream(row);
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST(SummaryTable, HasARowPerModelAndTheTruth) {
  const std::string table = summary_table(sample());
  EXPECT_THAT(words_of(row_of(table, "noisy, as built"))[0], "110");
  EXPECT_THAT(words_of(row_of(table, "noisy, final"))[0], "60");
  EXPECT_THAT(words_of(row_of(table, "corrected, as built"))[0], "31");
  EXPECT_THAT(words_of(row_of(table, "corrected, final")),
              testing::ElementsAre("24", "21", "1", "2", "5", "0.913", "99.0", "0.25", "7.5"));
  EXPECT_THAT(words_of(row_of(table, "truth"))[0], "22");
}

TEST(SummaryTable, PointsHaveATableOfTheirOwn) {
  Summary s = sample();
  EXPECT_EQ(row_of(summary_table(s), "by points"), "");
  s.points = {points_with(1), points_with(2), points_with(3), points_with(4)};
  const std::string table = summary_table(s);
  const std::string points = table.substr(table.find("by points"));
  EXPECT_THAT(words_of(row_of(points, "noisy, as built"))[0], "1");
  EXPECT_THAT(words_of(row_of(points, "corrected, final")),
              testing::ElementsAre("4", "11", "12", "3", "1", "0.682", "50.0", "75.0", "13"));
}

TEST(SummaryTable, ColumnsStandUnderTheirHeads) {
  std::istringstream lines(summary_table(sample()));
  std::string head, row;
  std::getline(lines, head);
  for (int i = 0; i < 4; ++i) {
    std::getline(lines, row);
    EXPECT_EQ(row.size(), head.size()) << row;
  }
}

TEST(SummaryTable, ErrorsWithoutAMatchAreADash) {
  const auto words = words_of(row_of(summary_table(Summary()), "noisy, as built"));
  ASSERT_EQ(words.size(), 9U);
  EXPECT_EQ(words[7], "-");
}

TEST(SummaryJson, StatesHowSureAnEstimateIs) {
  Summary s = sample();
  EXPECT_FALSE(json::parse(summary_to_json(s)).contains("estimate"));
  s.estimate.emplace();
  s.estimate->error.rmse_m = 0.05;
  EXPECT_EQ(json::parse(summary_to_json(s)).at("estimate").at("rmse_m"), 0.05);
  EXPECT_FALSE(json::parse(summary_to_json(s)).at("estimate").contains("nees"));
  EXPECT_NE(summary_table(s).find("position 5.0 cm RMS"), std::string::npos);
  s.estimate->report.emplace();
  s.estimate->report->precision = {0.01, 0.02, 0.3, 0.4};
  s.estimate->report->nees = 0.75;
  s.estimate->report->live.rmse_m = 0.06;
  s.estimate->report->live.largest_m = 0.25;
  const json estimate = json::parse(summary_to_json(s)).at("estimate");
  EXPECT_EQ(estimate.at("position_sigma_m_median"), 0.01);
  EXPECT_EQ(estimate.at("position_sigma_m_largest"), 0.02);
  EXPECT_EQ(estimate.at("heading_sigma_deg_median"), 0.3);
  EXPECT_EQ(estimate.at("heading_sigma_deg_largest"), 0.4);
  EXPECT_EQ(estimate.at("nees"), 0.75);
  EXPECT_EQ(estimate.at("live").at("rmse_m"), 0.06);
  EXPECT_EQ(estimate.at("live").at("largest_m"), 0.25);
  EXPECT_NE(summary_table(s).find("live 6.0 cm RMS (largest 25.0)"), std::string::npos);
}

}  // namespace
}  // namespace ribbon_mapper::eval
