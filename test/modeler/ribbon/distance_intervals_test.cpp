// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/distance_intervals.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace ribbon_mapper {
namespace {

constexpr double kGap = 0.06;

/// Returns the interval of each number, found by sorting.
std::map<double, std::size_t> sorted_intervals(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  std::map<double, std::size_t> intervals;
  std::size_t interval = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && numbers[i] - numbers[i - 1] > kGap) ++interval;
    intervals[numbers[i]] = interval;
  }
  return intervals;
}

TEST(DistanceIntervals, EqualThoseOfSortedNumbers) {
  std::mt19937 random(4);
  DistanceIntervals intervals(kGap);
  std::size_t max_intervals = 0;
  for (int run = 0; run < 500; ++run) {
    const int count = 1 + run % 60;
    std::uniform_real_distribution<double> number(-1.0, 1.0 + 0.01 * run);
    std::vector<double> numbers;
    for (int i = 0; i < count; ++i) numbers.push_back(number(random));
    intervals.clear();
    for (const double n : numbers) intervals.add(n);
    for (const auto& [n, interval] : sorted_intervals(numbers)) {
      ASSERT_EQ(interval, intervals.of(n)) << "run " << run << ", number " << n;
    }
    max_intervals = std::max(max_intervals, intervals.size());
  }
  EXPECT_GT(max_intervals, 15u);
}

TEST(DistanceIntervals, AreUnitedByANumberBetweenThem) {
  DistanceIntervals intervals(kGap);
  for (const double n : {0.0, 0.11, 1.0}) intervals.add(n);
  ASSERT_EQ(3u, intervals.size());
  intervals.add(0.055);
  ASSERT_EQ(2u, intervals.size());
  EXPECT_EQ(intervals.of(0.0), intervals.of(0.11));
  EXPECT_EQ(1u, intervals.of(1.0));
}

}  // namespace
}  // namespace ribbon_mapper
