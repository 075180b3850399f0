// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "eval/segmentation/duplication.hpp"
#include "eval/segmentation/evops.hpp"
#include "eval/segmentation/segcomp.hpp"
#include "test/eval/segmentation/slow_segmentation.hpp"

namespace ribbon_mapper::eval {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A number of points with the same true and estimated labels; -1 is no label.
struct Block {
  int truth, estimate;
  std::size_t points;
};

Overlaps overlaps_of(std::size_t truth, std::size_t estimates, const std::vector<Block>& blocks) {
  Overlaps overlaps(truth, estimates);
  for (const Block& block : blocks) overlaps.add(block.truth, block.estimate, block.points);
  return overlaps;
}

TEST(SegComp, APerfectModel) {
  const SegComp s = segcomp(overlaps_of(2, 2, {{0, 1, 100}, {1, 0, 300}}));
  EXPECT_EQ(s.correct, 2U);
  EXPECT_EQ(s.correct_share, 1.0);
  EXPECT_EQ(s.correct_points_share, 1.0);
  EXPECT_THAT(s.missed, IsEmpty());
  EXPECT_THAT(s.noise, IsEmpty());
}

TEST(SegComp, OneSplitInTwo) {
  const SegComp s = segcomp(overlaps_of(1, 2, {{0, 0, 60}, {0, 1, 40}}));
  EXPECT_EQ(s.correct, 0U);
  EXPECT_EQ(s.over, 1U);
  EXPECT_THAT(s.missed, IsEmpty());
  EXPECT_THAT(s.noise, IsEmpty());
}

TEST(SegComp, TwoJoined) {
  const SegComp s = segcomp(overlaps_of(2, 1, {{0, 0, 60}, {1, 0, 40}}));
  EXPECT_EQ(s.under, 1U);
  EXPECT_EQ(s.correct, 0U);
  EXPECT_THAT(s.missed, IsEmpty());
  EXPECT_THAT(s.noise, IsEmpty());
}

TEST(SegComp, OneMissedAndOneExtra) {
  const SegComp s = segcomp(overlaps_of(2, 2, {{0, 0, 50}, {1, -1, 150}, {-1, 1, 30}}));
  EXPECT_EQ(s.correct, 1U);
  EXPECT_THAT(s.missed, ElementsAre(1U));
  EXPECT_THAT(s.noise, ElementsAre(1U));
  EXPECT_EQ(s.correct_share, 0.5);
  EXPECT_EQ(s.correct_points_share, 0.25);
}

// Two estimates of one wall, from points that were observed at different times.
TEST(SegComp, AWallDoubledByDrift) {
  const SegComp even = segcomp(overlaps_of(1, 2, {{0, 0, 55}, {0, 1, 45}}));
  EXPECT_EQ(even.over, 1U);
  const SegComp uneven = segcomp(overlaps_of(1, 2, {{0, 0, 90}, {0, 1, 10}}));
  EXPECT_EQ(uneven.correct, 0U) << "0.95 for correct, 1 for over-segmented";
  EXPECT_EQ(uneven.over, 1U);
}

TEST(SegComp, SharesMustExceedTheTolerance) {
  EXPECT_EQ(segcomp(overlaps_of(1, 1, {{0, 0, 80}, {0, -1, 20}})).correct, 0U);
  EXPECT_EQ(segcomp(overlaps_of(1, 1, {{0, 0, 81}, {0, -1, 19}})).correct, 1U);
  EXPECT_EQ(segcomp(overlaps_of(1, 1, {{0, 0, 80}, {-1, 0, 20}})).correct, 0U);
}

// A small region beside a correct pair could make the pair under-segmented; the higher mean share
// decides.
TEST(SegComp, ClassesCompeteByTheirScores) {
  const SegComp lumped = segcomp(overlaps_of(2, 1, {{0, 0, 90}, {1, 0, 10}}));
  EXPECT_EQ(lumped.under, 1U) << "1 for under-segmented, 0.95 for correct";
  EXPECT_EQ(lumped.correct, 0U);
  const SegComp correct = segcomp(overlaps_of(2, 1, {{0, 0, 100}, {1, 0, 5}, {1, -1, 1}}));
  EXPECT_EQ(correct.correct, 1U) << "0.976 for correct, 0.958 for under-segmented";
  EXPECT_EQ(correct.under, 0U);
  EXPECT_THAT(correct.missed, ElementsAre(1U));
}

TEST(SegComp, EmptySidesAndBadTolerances) {
  EXPECT_THAT(segcomp(Overlaps(2, 0)).missed, ElementsAre(0U, 1U));
  EXPECT_THAT(segcomp(Overlaps(0, 2)).noise, ElementsAre(0U, 1U));
  EXPECT_EQ(segcomp(Overlaps(0, 0)).correct_share, 0.0);
  EXPECT_THROW(segcomp(Overlaps(1, 1), 0.4), std::invalid_argument);
}

TEST(Evops, APerfectModel) {
  const Evops e = evops(overlaps_of(2, 2, {{0, 1, 100}, {1, 0, 300}}));
  EXPECT_EQ(e.f1, 1.0);
  EXPECT_EQ(e.noise + e.missed + e.under_segmented + e.over_segmented, 0.0);
}

TEST(Evops, HandMadeCases) {
  const Evops split = evops(overlaps_of(1, 2, {{0, 0, 60}, {0, 1, 40}}));
  EXPECT_EQ(split.over_segmented, 1.0);
  EXPECT_EQ(split.matched, 0U);
  EXPECT_EQ(split.noise + split.missed, 0.0);
  const Evops joined = evops(overlaps_of(2, 1, {{0, 0, 60}, {1, 0, 40}}));
  EXPECT_EQ(joined.under_segmented, 1.0);
  const Evops both = evops(overlaps_of(2, 2, {{0, 0, 50}, {1, -1, 50}, {-1, 1, 30}}));
  EXPECT_EQ(both.precision, 0.5);
  EXPECT_EQ(both.recall, 0.5);
  EXPECT_EQ(both.noise, 0.5);
  EXPECT_EQ(both.missed, 0.5);
}

TEST(Evops, WholePairsBeginAtThreeQuarters) {
  EXPECT_EQ(evops(overlaps_of(1, 1, {{0, 0, 75}, {0, -1, 25}})).matched, 1U);
  const Evops less = evops(overlaps_of(1, 1, {{0, 0, 74}, {0, -1, 26}}));
  EXPECT_EQ(less.matched, 0U);
  EXPECT_EQ(less.missed, 1.0) << "a partial partner alone is none";
}

// Each of six equal parts is too small for a partial match of EVOPS; SegComp counts them.
TEST(Evops, ManyPartsAreMissedAndNoise) {
  std::vector<Block> blocks;
  for (int part = 0; part < 6; ++part) blocks.push_back({0, part, 10});
  const Evops e = evops(overlaps_of(1, 6, blocks));
  EXPECT_EQ(e.missed, 1.0);
  EXPECT_EQ(e.noise, 1.0);
  EXPECT_EQ(segcomp(overlaps_of(1, 6, blocks)).over, 1U);
}

TEST(Duplication, CountsTheCopiesOfATruePlane) {
  const Duplication none = duplication(overlaps_of(2, 2, {{0, 0, 10}, {1, 1, 10}}));
  EXPECT_EQ(none.duplicates, 0U);
  EXPECT_EQ(none.ratio, 1.0);
  const Duplication doubled = duplication(
      overlaps_of(3, 5, {{0, 0, 10}, {0, 1, 6}, {1, 1, 5}, {0, 2, 3}, {1, 3, 4}, {-1, 4, 9}}));
  EXPECT_EQ(doubled.duplicates, 2U) << "0, 1 and 2 are the first plane's, 3 the second's";
  EXPECT_EQ(doubled.ratio, 2.0);
  EXPECT_FALSE(duplication(overlaps_of(1, 1, {{0, 0, 5}, {-1, 0, 5}})).ratio) << "half is not most";
}

/// Labels of few points, similar enough that all classes occur and compete.
struct Labelling {
  Regions truth, estimates;
  Overlaps overlaps{0, 0};
};

Labelling random_labelling(std::mt19937& random) {
  const auto any = [&](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  const int truth = 1 + any(5), estimates = 1 + any(5);
  Labelling labelling{
      Regions(truth), Regions(estimates),
      Overlaps(static_cast<std::size_t>(truth), static_cast<std::size_t>(estimates))};
  const int blocks = 1 + any(8);
  int point = 0;
  for (int block = 0; block < blocks; ++block) {
    const int t = any(6) == 0 ? -1 : any(truth), e = any(6) == 0 ? -1 : any(estimates);
    for (int size = 1 + any(any(2) ? 5 : 30); size > 0; --size, ++point) {
      if (t >= 0) labelling.truth[t].insert(point);
      if (e >= 0) labelling.estimates[e].insert(point);
      labelling.overlaps.add(t, e);
    }
  }
  return labelling;
}

template <typename Names>
std::size_t count_of(const Names& names, const char* name) {
  return static_cast<std::size_t>(std::count(names.begin(), names.end(), name));
}

TEST(Segmentation, AgreesWithTheSlowDefinitions) {
  std::mt19937 random(1);
  std::size_t over = 0, under = 0, correct = 0;
  for (int round = 0; round < 5000; ++round) {
    const Labelling labelling = random_labelling(random);
    const SegComp fast = segcomp(labelling.overlaps);
    const SlowSegComp slow = slow_segcomp(labelling.truth, labelling.estimates, 0.8);
    ASSERT_EQ(fast.correct, count_of(slow.truth, "correct")) << round;
    ASSERT_EQ(fast.over, count_of(slow.truth, "over")) << round;
    ASSERT_EQ(fast.under, count_of(slow.estimates, "under")) << round;
    ASSERT_EQ(fast.missed.size(), count_of(slow.truth, "missed")) << round;
    ASSERT_EQ(fast.noise.size(), count_of(slow.estimates, "noise")) << round;
    over += fast.over, under += fast.under, correct += fast.correct;

    const Evops a = evops(labelling.overlaps);
    const Evops b = slow_evops(labelling.truth, labelling.estimates);
    ASSERT_EQ(a.matched, b.matched) << round;
    ASSERT_NEAR(a.f1, b.f1, 1e-12) << round;
    ASSERT_EQ(a.under_segmented, b.under_segmented) << round;
    ASSERT_EQ(a.over_segmented, b.over_segmented) << round;
    ASSERT_EQ(a.noise, b.noise) << round;
    ASSERT_EQ(a.missed, b.missed) << round;
  }
  EXPECT_GT(over, 100U) << "the cases must be there to be compared";
  EXPECT_GT(under, 100U);
  EXPECT_GT(correct, 1000U);
}

}  // namespace
}  // namespace ribbon_mapper::eval
