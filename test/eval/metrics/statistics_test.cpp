// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/metrics/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ribbon_mapper::eval {
namespace {

// Expected values are from numpy.quantile().
TEST(Statistics, QuantilesLieBetweenTheValues) {
  EXPECT_DOUBLE_EQ(quantile({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 2.0, 3.0}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 2.0, 3.0}, 0.25), 1.75);
  EXPECT_DOUBLE_EQ(quantile({4.0, 1.0, 2.0, 3.0}, 1.0), 4.0);
  EXPECT_DOUBLE_EQ(quantile({7.0}, 0.75), 7.0);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(Statistics, Mean) {
  EXPECT_DOUBLE_EQ(mean_of({1.0, 2.0, 6.0}), 3.0);
  EXPECT_TRUE(std::isnan(mean_of({})));
}

}  // namespace
}  // namespace ribbon_mapper::eval
