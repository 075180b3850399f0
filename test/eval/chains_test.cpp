// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/chains.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace ribbon_mapper::eval {
namespace {

double length_of(const Chain& chain) {
  double length = 0.0;
  for (std::size_t i = 1; i < chain.size(); ++i) length += (chain[i] - chain[i - 1]).norm();
  return length;
}

TEST(Chains, ABoxInPiecesIsOneClosedChainOfFourCorners) {
  const std::vector<Segment> pieces{{{{0, 0}, {1, 0}}}, {{{1, 0}, {2, 0}}},   {{{2, 1}, {2, 0}}},
                                    {{{0, 1}, {2, 1}}}, {{{0, 0.5}, {0, 1}}}, {{{0, 0}, {0, 0.5}}}};
  const auto chains = chains_of(pieces, 0.005);
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].size(), 5U);
  EXPECT_EQ(chains[0].front(), chains[0].back());
  EXPECT_NEAR(length_of(chains[0]), 6.0, 1e-12);
}

TEST(Chains, ASegmentThatComesTwiceIsThereOnce) {
  const auto chains = chains_of({{{{0, 0}, {1, 0}}}, {{{1, 0}, {0, 0}}}}, 0.005);
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].size(), 2U);
}

TEST(Chains, AFineCircleKeepsItsShapeWithFewPoints) {
  std::vector<Segment> pieces;
  const auto at = [](int i) {
    const double angle = 2.0 * M_PI * (i % 400) / 400.0;
    return Eigen::Vector2d(std::cos(angle), std::sin(angle));
  };
  for (int i = 0; i < 400; ++i) pieces.push_back({at(i), at(i + 1)});
  const auto chains = chains_of(pieces, 0.005);
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_LT(chains[0].size(), 50U);
  EXPECT_NEAR(length_of(chains[0]), 2.0 * M_PI, 0.03);
}

TEST(Chains, AJunctionLosesNothing) {
  const std::vector<Segment> cross{
      {{{0, 0}, {1, 0}}}, {{{0, 0}, {-1, 0}}}, {{{0, 0}, {0, 1}}}, {{{0, 0}, {0, 2}}}};
  double length = 0.0;
  for (const Chain& chain : chains_of({cross[0], cross[1], cross[2]}, 0.005)) {
    length += length_of(chain);
  }
  EXPECT_NEAR(length, 3.0, 1e-12);
}

TEST(Chains, PointsWithinTheToleranceGo) {
  const Chain chain{{0, 0}, {1, 0.004}, {2, 0}, {3, 0.006}, {4, 0}};
  EXPECT_THAT(simplified(chain, 0.005), testing::ElementsAre(chain[0], chain[3], chain[4]));
  EXPECT_THAT(simplified({}, 0.005), testing::IsEmpty());
}

}  // namespace
}  // namespace ribbon_mapper::eval
