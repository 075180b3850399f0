// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/sweep.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <mutex>
#include <stdexcept>

namespace ribbon_mapper::eval {
namespace {

using testing::SizeIs;

Summary summary_of(std::uint64_t seed) {
  Summary summary;
  summary.seed = seed;
  return summary;
}

/// run_seeds() without its output.
std::vector<Summary> quietly(const std::vector<std::uint64_t>& seeds, std::size_t jobs,
                             const SeedRun& run) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const auto restore = [] {
    testing::internal::GetCapturedStdout();
    testing::internal::GetCapturedStderr();
  };
  try {
    ProgressBar bar;
    const auto summaries = run_seeds(seeds, jobs, run, bar);
    restore();
    return summaries;
  } catch (...) {
    restore();
    throw;
  }
}

class Sweep : public testing::TestWithParam<std::size_t> {};

TEST_P(Sweep, EverySeedRunsOnceAndKeepsItsPlace) {
  std::mutex mutex;
  std::vector<std::uint64_t> begun;
  const std::vector<std::uint64_t> seeds{9, 3, 7, 1, 5};
  const auto summaries = quietly(seeds, GetParam(), [&](std::uint64_t seed, const auto& progress) {
    progress({1, 1, 0, 0.0, 0.0});
    const std::lock_guard<std::mutex> lock(mutex);
    begun.push_back(seed);
    return summary_of(seed);
  });
  EXPECT_THAT(begun, testing::UnorderedElementsAreArray(seeds));
  ASSERT_THAT(summaries, SizeIs(seeds.size()));
  for (std::size_t i = 0; i < seeds.size(); ++i) EXPECT_EQ(summaries[i].seed, seeds[i]);
}

TEST_P(Sweep, AFailureIsReportedAndNoFurtherSeedBegins) {
  std::atomic<int> begun{0};
  const auto run = [&](std::uint64_t, const auto&) -> Summary {
    ++begun;
    throw std::runtime_error("no such world");
  };
  EXPECT_THAT(
      [&] {
        quietly({1, 2, 3, 4, 5, 6, 7, 8}, GetParam(), run);
      },
      testing::ThrowsMessage<std::runtime_error>("no such world"));
  EXPECT_LE(begun, static_cast<int>(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Jobs, Sweep, testing::Values(1U, 3U, 16U));

}  // namespace
}  // namespace ribbon_mapper::eval
