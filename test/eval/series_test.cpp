// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment/series.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <mutex>
#include <stdexcept>

namespace ribbon_mapper::eval {
namespace {

std::vector<RunOptions> runs_of(const std::vector<std::uint64_t>& seeds) {
  std::vector<RunOptions> runs;
  for (const std::uint64_t seed : seeds) runs.emplace_back().seed = seed;
  return runs;
}

class Series : public testing::TestWithParam<std::size_t> {
 protected:
  void SetUp() override {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
  }
  void TearDown() override {
    testing::internal::GetCapturedStdout();
    testing::internal::GetCapturedStderr();
  }
};

TEST_P(Series, EveryRunIsMadeOnceAndPrinted) {
  std::mutex mutex;
  std::vector<std::uint64_t> begun;
  const std::vector<std::uint64_t> seeds{9, 3, 7, 1, 5};
  {
    ProgressBar bar;
    make_runs(
        runs_of(seeds), GetParam(),
        [&](const RunOptions& run, const auto& progress) {
          progress({1, 1, 0, 0.0, 0.0});
          const std::lock_guard<std::mutex> lock(mutex);
          begun.push_back(run.seed);
          return "done " + std::to_string(run.seed) + "\n";
        },
        bar);
  }
  EXPECT_THAT(begun, testing::UnorderedElementsAreArray(seeds));
  const std::string printed = testing::internal::GetCapturedStdout();
  testing::internal::CaptureStdout();
  for (const std::uint64_t seed : seeds) {
    EXPECT_THAT(printed, testing::HasSubstr("done " + std::to_string(seed) + "\n"));
  }
}

TEST_P(Series, AFailureIsReportedAndNoFurtherRunBegins) {
  std::atomic<int> begun{0};
  const auto run = [&](const RunOptions&, const auto&) -> std::string {
    ++begun;
    throw std::runtime_error("no such world");
  };
  ProgressBar bar;
  EXPECT_THAT(
      [&] {
        make_runs(runs_of({1, 2, 3, 4, 5, 6, 7, 8}), GetParam(), run, bar);
      },
      testing::ThrowsMessage<std::runtime_error>("no such world"));
  EXPECT_LE(begun, static_cast<int>(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Jobs, Series, testing::Values(1U, 3U, 16U));

}  // namespace
}  // namespace ribbon_mapper::eval
