// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/floor_plan/intervals.hpp"

#include <gtest/gtest.h>

namespace ribbon_mapper {
namespace {

void expect_equal(const Intervals& expected, const Intervals& found) {
  ASSERT_EQ(expected.size(), found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_DOUBLE_EQ(expected[i].begin, found[i].begin);
    EXPECT_DOUBLE_EQ(expected[i].end, found[i].end);
  }
}

TEST(Intervals, AreUnitedWhereTheyTouchOrNearly) {
  expect_equal({{0, 3}, {4, 5}}, united({{4, 5}, {0, 2}, {1, 3}}));
  expect_equal({{0, 5}}, united({{4, 5}, {0, 2}, {1, 3}}, 1.0));
  expect_equal({{0, 9}}, united({{0, 9}, {1, 2}}));
}

TEST(Intervals, IntersectWhereBothAre) {
  expect_equal({{1, 2}, {4, 5}}, intersection({{0, 2}, {4, 6}}, {{1, 5}}));
  expect_equal({}, intersection({{0, 1}}, {{1, 2}}));
}

TEST(Intervals, LoseWhatIsRemoved) {
  expect_equal({{0, 1}, {2, 3}}, difference({{0, 3}}, Interval{1, 2}));
  expect_equal({{0, 3}}, difference({{0, 3}}, Interval{4, 5}));
  expect_equal({}, difference({{1, 2}}, Interval{0, 5}));
  expect_equal({{0, 1}, {4, 5}}, difference({{0, 2}, {3, 5}}, Intervals{{1, 2.5}, {3, 4}}));
}

}  // namespace
}  // namespace ribbon_mapper
