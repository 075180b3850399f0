// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/results.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "modeler/io/tum.hpp"
#include "test/eval/sample_results.hpp"
#include "test/io/temporary_directory.hpp"
#include "test/storage/full_disk.hpp"

namespace ribbon_mapper::eval {
namespace {

TEST(Results, EachModelIsComparedWithTheTruth) {
  Results results = sample_results();
  evaluate(results);
  const FourMetrics& metrics = results.summary.metrics;
  EXPECT_EQ(metrics.noisy_as_built.planes, 3U);
  EXPECT_EQ(metrics.noisy_as_built.matched, 1U);
  EXPECT_EQ(metrics.noisy_as_built.duplicates.size(), 1U);
  EXPECT_EQ(metrics.noisy_as_built.extra.size(), 1U);
  EXPECT_EQ(metrics.noisy.planes, 2U);
  EXPECT_EQ(metrics.corrected_as_built.planes, 1U);
  EXPECT_EQ(metrics.corrected.f1, 1.0);
}

TEST(Results, EndDriftIsThatOfTheLastPoseInItsOwnFrame) {
  Results results = sample_results();
  evaluate(results);
  EXPECT_NEAR(results.summary.end_drift_m, 0.5, 1e-9);
  EXPECT_NEAR(results.summary.end_drift_deg, 10.0, 1e-9);
}

TEST(Results, WritesTheFilesOfTheDemo) {
  const TemporaryDirectory directory;
  Results results = sample_results();
  evaluate(results);
  write_results(results, directory.path() / "run");
  for (const char* name :
       {"summary.json", "planes_before.json", "planes_noisy.json", "planes_after.json",
        "planes_after.ply", "planes_after_cells.ply", "planes_after.bt", "planes_truth.json",
        "trajectory_before.tum", "trajectory_after.tum", "trajectory_truth.tum", "figure.json",
        "report.html"}) {
    EXPECT_TRUE(std::filesystem::exists(directory.path() / "run" / name)) << name;
  }
  const auto planes = [&](const char* name) {
    return nlohmann::json::parse(content_of(directory.path() / "run" / name)).at("planes").size();
  };
  EXPECT_EQ(planes("planes_before.json"), 3U);
  EXPECT_EQ(planes("planes_noisy.json"), 2U);
  EXPECT_EQ(planes("planes_after.json"), 1U);
  EXPECT_EQ(planes("planes_truth.json"), 1U);
}

TEST(Results, TheLiveTrajectoryIsWrittenIfThereIsOne) {
  const TemporaryDirectory directory;
  Results results = sample_results();
  write_results(results, directory.path() / "truth");
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "truth" / "trajectory_live.tum"));
  results.trajectory_live = {results.trajectory_truth.back()};
  write_results(results, directory.path() / "self");
  EXPECT_EQ(read_tum(directory.path() / "self" / "trajectory_live.tum").size(), 1U);
}

TEST(Results, PlanesWithoutOutlineGetOne) {
  const TemporaryDirectory directory;
  Results results = sample_results();
  for (Plane& plane : results.models.noisy_as_built) plane.outlines.clear();
  write_results(results, directory.path());
  const auto json = nlohmann::json::parse(content_of(directory.path() / "planes_before.json"));
  for (const auto& plane : json.at("planes"))
    EXPECT_GE(plane.at("outlines").at(0).at(0).size(), 4U);
}

TEST(Results, TheSameResultsGiveTheSameBytes) {
  const TemporaryDirectory directory;
  for (const char* name : {"a", "b"}) write_results(sample_results(), directory.path() / name);
  for (const auto& file : std::filesystem::directory_iterator(directory.path() / "a")) {
    if (!std::filesystem::is_regular_file(file)) continue;
    EXPECT_EQ(content_of(file), content_of(directory.path() / "b" / file.path().filename()))
        << file.path();
  }
}

TEST(Results, AllFilesNameTheRun) {
  const TemporaryDirectory directory;
  write_results(sample_results(), directory.path());
  const auto summary = nlohmann::json::parse(content_of(directory.path() / "summary.json"));
  const auto id = summary.at("run").get<std::string>();
  EXPECT_EQ(id.size(), 16U);
  for (const auto& entry : std::filesystem::directory_iterator(directory.path())) {
    if (!std::filesystem::is_regular_file(entry)) continue;
    EXPECT_THAT(content_of(entry), testing::HasSubstr(id)) << entry;
  }
}

TEST(Results, OneRunReplacesTheFilesOfAnother) {
  const TemporaryDirectory directory;
  FileSet with_figure = staged_results(sample_results(), directory.path());
  with_figure.add("before_after.png", "a figure of this run");
  with_figure.commit();
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "before_after.png"));
  write_results(sample_results(), directory.path());
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "before_after.png"));
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "planes_after.json"));
}

TEST(Results, AFullDiskAtAnyFileLeavesTheRunBefore) {
  const TemporaryDirectory directory;
  write_results(sample_results(), directory.path());
  const std::string before = content_of(directory.path() / "summary.json");
  Results other = sample_results();
  other.models.corrected[0].d_m += 0.001;
  for (const rlim_t bytes : {0, 100, 500, 1000, 2000, 5000, 20'000, 40'000}) {
    const FullDisk disk(bytes);
    EXPECT_THROW(write_results(other, directory.path()), std::runtime_error) << bytes;
    EXPECT_EQ(content_of(directory.path() / "summary.json"), before);
  }
  write_results(other, directory.path());
  EXPECT_NE(content_of(directory.path() / "summary.json"), before);
}

TEST(Results, ADirectoryThatCannotBeIsNamed) {
  EXPECT_THAT([] { write_results(sample_results(), "/proc/nowhere"); },
              testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("/proc/nowhere")));
}

}  // namespace
}  // namespace ribbon_mapper::eval
