// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/matching/correlative_search.hpp"

#include <gtest/gtest.h>

#include "test/slam/matching/wall_world.hpp"

namespace ribbon_mapper::slam {
namespace {

LevelPoints seen_from(const WallWorld& world, const PlanarPose& pose) {
  return thinned(world.scan(pose, 1.0, true).points, 0.2);
}

TEST(CorrelativeSearch, FindsThePoseInARoom) {
  const WallWorld world = WallWorld::room();
  const CorrelativeSearch search(world.scan({}, 1.0, true).points);
  const PlanarPose truth{0.7, -0.4, 0.5};
  const auto found = search.find(seen_from(world, truth), {}, {2.0, 1.0, 0.5}, 0.9);
  ASSERT_TRUE(found);
  EXPECT_LT(distance_m(found->T_map_base, truth), 1.5 * CorrelativeSearch::kCell_m);
  EXPECT_NEAR(found->T_map_base.yaw_rad, truth.yaw_rad, 0.03);
  EXPECT_GT(found->score, 0.8);
  EXPECT_EQ(found->second_score, 0.0) << "there is no other such place";
}

TEST(CorrelativeSearch, ScoresAsTheBestOfAllPosesTriedOneByOne) {
  // a search of one position and few angles scores exactly that position: all of them together are
  // the slow definition of a large window
  const WallWorld world = WallWorld::room();
  const CorrelativeSearch search(world.scan({}, 1.0, true).points);
  const LevelPoints points = seen_from(world, {0.3, 0.2, 0.1});
  const auto found = search.find(points, {}, {0.8, 0.12, 0.1}, 0.0);
  ASSERT_TRUE(found);
  double best = 0.0;
  for (int x = -7; x <= 7; ++x) {
    for (int y = -7; y <= 7; ++y) {
      const PlanarPose guess{x * CorrelativeSearch::kCell_m, y * CorrelativeSearch::kCell_m, 0.0};
      const auto near = search.find(points, guess, {0.1, 0.12, 0.1}, 0.0);
      if (near) best = std::max(best, near->score);
    }
  }
  EXPECT_NEAR(found->score, best, 0.02);  // cells of a moved guess round differently
}

TEST(CorrelativeSearch, TellsThatASecondPlaceFitsAsWell) {
  const WallWorld world = WallWorld::square();
  const CorrelativeSearch search(world.scan({}, 1.0, true).points);
  const LevelPoints points = seen_from(world, {0.4, 0.2, 0.1});
  const auto narrow = search.find(points, {0.4, 0.2, 0.1}, {0.5, 0.3, 0.5}, 0.9);
  ASSERT_TRUE(narrow);
  EXPECT_EQ(narrow->second_score, 0.0);
  const auto wide = search.find(points, {0.4, 0.2, 0.1}, {1.5, M_PI, 0.5}, 0.9);
  ASSERT_TRUE(wide);
  EXPECT_GE(wide->second_score, 0.9 * wide->score) << "a quarter turn";
}

TEST(CorrelativeSearch, FindsNothingElsewhere) {
  const CorrelativeSearch search(WallWorld::room().scan({}, 1.0, true).points);
  const LevelPoints points = seen_from(WallWorld::square(), {});
  EXPECT_FALSE(search.find(points, {}, {0.3, 0.1, 0.9}, 0.9));
  EXPECT_FALSE(search.find({}, {}, {0.3, 0.1, 0.1}, 0.9)) << "no points";
  const CorrelativeSearch empty(LevelPoints{});
  EXPECT_FALSE(empty.find(points, {}, {0.3, 0.1, 0.1}, 0.9)) << "no map";
}

}  // namespace
}  // namespace ribbon_mapper::slam
