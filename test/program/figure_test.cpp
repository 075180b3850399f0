// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/program/figure.hpp"

#include <gmock/gmock.h>

#include "eval/results/series_summary.hpp"
#include "test/eval/sample_results.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper::eval {
namespace {

using testing::HasSubstr;

/// Searches a text without printing all of it on failure, as HasSubstr would.
bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

TEST(Figure, IsDrawnFromTheFilesOfARun) {
  const TemporaryDirectory directory;
  Results results = sample_results();
  evaluate(results);
  write_results(results, directory.path());
  ASSERT_TRUE(draw_figure(Figure::before_after, directory.path()));
  EXPECT_EQ(content_of(directory.path() / "before_after.png").substr(1, 3), "PNG");
  const std::string svg = content_of(directory.path() / "before_after.svg");
  for (const char* text :
       {"Before the correction: 2 planes", "as built during the tour: 3",
        "After the correction: 1 plane", "truth: 1", "1 of 1 true plane found", "</svg>"}) {
    EXPECT_TRUE(has(svg, text)) << text;
  }
  ASSERT_TRUE(draw_figure(Figure::before_after, directory.path()));
  EXPECT_TRUE(content_of(directory.path() / "before_after.svg") == svg) << "other bytes";
}

TEST(Figure, DoseAndResponseIsDrawnFromTheSummaryOfASeries) {
  const TemporaryDirectory directory;
  std::vector<LoggedRun> runs;
  for (const double drift : {0.0, 2.0}) {
    Results results = sample_results();
    evaluate(results);
    results.summary.run.drift = drift;
    results.summary.points.emplace();
    runs.push_back(parse_run_line(run_line(results.summary, "")));
  }
  write_content(directory.path() / "summary.json", series_summary_to_json(runs, ""));
  ASSERT_TRUE(draw_figure(Figure::dose_response, directory.path()));
  EXPECT_EQ(content_of(directory.path() / "dose_response.png").substr(1, 3), "PNG");
  const std::string svg = content_of(directory.path() / "dose_response.svg");
  for (const char* text : {"1 seeds per drift", "Number of planes", "0.5 m", "truth", "</svg>"}) {
    EXPECT_TRUE(has(svg, text)) << text;
  }
}

TEST(Figure, EmptyModelsCanBeDrawn) {
  const TemporaryDirectory directory;
  write_results(Results(), directory.path());
  EXPECT_TRUE(draw_figure(Figure::before_after, directory.path()));
}

TEST(Figure, WithoutTheFilesAWarningSaysWhatToDo) {
  const TemporaryDirectory directory;
  testing::internal::CaptureStderr();
  EXPECT_FALSE(draw_figure(Figure::before_after, directory.path()));
  const std::string warning = testing::internal::GetCapturedStderr();
  EXPECT_THAT(warning, testing::Not(HasSubstr("python3-matplotlib"))) << "it is not the cause";
  EXPECT_THAT(warning, HasSubstr("for the reason above"));
  EXPECT_THAT(warning, HasSubstr("before_after.py"));
  EXPECT_EQ(directory.file_count(), 0U);
}

TEST(Figure, AFloorPlanThatCannotBeDrawnIsNamed) {
  const TemporaryDirectory directory;
  testing::internal::CaptureStderr();
  EXPECT_FALSE(draw_floor_plan(directory.path()));
  const std::string warning = testing::internal::GetCapturedStderr();
  EXPECT_THAT(warning, HasSubstr("floor_plan.svg and .png were not drawn"));
  EXPECT_THAT(warning, HasSubstr("floor_plan.dxf was not drawn"));
}

}  // namespace
}  // namespace ribbon_mapper::eval
