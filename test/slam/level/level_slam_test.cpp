// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/level/level_slam.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "test/slam/matching/wall_world.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr double kStep_m = 0.15;

LevelSlamResult mapped(const WallWorld& world, const std::vector<PlanarPose>& truth,
                       const std::vector<PlanarPose>& odometry, const LevelSlamConfig& config) {
  LevelSlam slam(config);
  for (std::size_t i = 0; i < truth.size(); ++i)
    slam.add(world.scan(truth[i], 10.0 + 0.2 * static_cast<double>(i)), odometry[i]);
  return slam.finish();
}

double largest_error_m(const LevelSlamResult& result, const std::vector<PlanarPose>& truth) {
  double most = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    most = std::max(most,
                    distance_m(result.trajectory[i].T_map_base, relative(truth.front(), truth[i])));
  }
  return most;
}

std::size_t accepted(const LevelSlamResult& result) {
  std::size_t count = 0;
  for (const Loop& loop : result.loops) count += loop.verdict == LoopVerdict::accepted ? 1 : 0;
  return count;
}

/// Two laps in a ring with odometry that drifts by metres.
class Ring : public testing::Test {
 protected:
  const WallWorld world = WallWorld::ring();
  const std::vector<PlanarPose> truth = ring_drive(1.6, kStep_m);
  const std::vector<PlanarPose> odometry = drifting(truth, 0.04, 0.01);
};

TEST_F(Ring, IsClosed) {
  const LevelSlamResult result = mapped(world, truth, odometry, {});
  ASSERT_EQ(result.trajectory.size(), truth.size());
  double drift_m = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    drift_m = std::max(drift_m, distance_m(truth[i], odometry[i]));
  EXPECT_GT(drift_m, 2.0);
  EXPECT_LT(largest_error_m(result, truth), 0.15);
  EXPECT_GT(accepted(result), 10U);
}

TEST_F(Ring, EachAcceptedLoopIsTrue) {
  const LevelSlamResult result = mapped(world, truth, odometry, {});
  for (const Loop& loop : result.loops) {
    if (loop.verdict != LoopVerdict::accepted) continue;
    const auto at = [&](std::size_t keyframe) {
      const double seconds = to_seconds(result.keyframe_stamps[keyframe]) - 10.0;
      return truth[static_cast<std::size_t>(std::lround(seconds / 0.2))];
    };
    EXPECT_LT(distance_m(relative(at(loop.from), at(loop.to)), loop.T_from_to), 0.1);
  }
}

TEST_F(Ring, SameInputGivesTheSameResult) {
  const LevelSlamResult first = mapped(world, truth, odometry, {});
  const LevelSlamResult second = mapped(world, truth, odometry, {});
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_EQ(first.trajectory[i].T_map_base.vector(), second.trajectory[i].T_map_base.vector());
    EXPECT_EQ(first.trajectory[i].stamp, second.trajectory[i].stamp);
  }
}

TEST_F(Ring, OdometryThatStandsStillAndJumpsIsPutRight) {
  std::vector<PlanarPose> jumping = odometry;
  const std::size_t corner = static_cast<std::size_t>(15.0 / kStep_m);  // the first turn begins
  for (std::size_t i = corner; i < corner + 4; ++i) jumping[i] = odometry[corner];
  EXPECT_LT(largest_error_m(mapped(world, truth, jumping, {}), truth), 0.15);
}

TEST_F(Ring, OdometryThatMovesTwiceTheWayIsPutRight) {
  std::vector<PlanarPose> doubled = odometry;
  const std::size_t begin = static_cast<std::size_t>(3.0 / kStep_m), end = 2 * begin;
  for (std::size_t i = begin; i < odometry.size(); ++i) {
    PlanarPose step = relative(odometry[i - 1], odometry[i]);
    if (i < end) step.x_m *= 2.0;
    doubled[i] = doubled[i - 1] * step;
  }
  EXPECT_LT(largest_error_m(mapped(world, truth, doubled, {}), truth), 0.15);
}

TEST(LevelSlam, WithoutScansThereIsNothing) {
  LevelSlam slam({});
  const LevelSlamResult result = slam.finish();
  EXPECT_TRUE(result.trajectory.empty());
  EXPECT_TRUE(result.loops.empty());
}

TEST(LevelSlam, OneScanIsTheOrigin) {
  LevelSlam slam({});
  slam.add(WallWorld::room().scan({}), {5.0, 6.0, 1.0});
  const LevelSlamResult result = slam.finish();
  ASSERT_EQ(result.trajectory.size(), 1U);
  EXPECT_LT(result.trajectory[0].T_map_base.vector().norm(), 1e-3);
}

TEST(LevelSlam, FollowsOdometryWhereNothingIsSeen) {
  LevelSlam slam({});
  for (int i = 0; i < 20; ++i) slam.add({from_seconds(1.0 + i), {}}, {0.3 * i, 0.0, 0.0});
  const LevelSlamResult result = slam.finish();
  EXPECT_NEAR(result.trajectory.back().T_map_base.x_m, 0.3 * 19, 1e-6);
}

TEST(LevelSlam, RefusesWhatIsNotFiniteOrNotLaterAndGoesOn) {
  const WallWorld world = WallWorld::room();
  LevelSlam slam({});
  slam.add(world.scan({}, 1.0), {});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(slam.add(world.scan({}, 2.0), {nan, 0.0, 0.0}), std::invalid_argument);
  LevelScan broken = world.scan({}, 2.0);
  broken.points[3].x_m = std::numeric_limits<float>::infinity();
  EXPECT_THROW(slam.add(broken, {}), std::invalid_argument);
  EXPECT_THROW(slam.add(world.scan({}, 1.0), {}), std::invalid_argument);
  slam.add(world.scan({0.1, 0.0, 0.0}, 2.0), {0.1, 0.0, 0.0});
  const LevelSlamResult result = slam.finish();
  ASSERT_EQ(result.trajectory.size(), 2U);
  EXPECT_NEAR(result.trajectory[1].T_map_base.x_m, 0.1, 0.005);
}

TEST(PlanarOdometryNoise, LearnsHowExactTheOdometryIs) {
  const PlanarPose step{0.2, 0.0, 0.0};
  PlanarOdometryNoise exact({}), coarse({});
  for (int i = 0; i < 500; ++i) {
    const double sign = i % 2 == 0 ? 1.0 : -1.0;
    exact.learn(step, {sign * 0.002, 0.0, sign * 0.0005});
    coarse.learn(step, {sign * 0.05, 0.0, sign * 0.02});
  }
  EXPECT_LT(exact.scale_xy(), 0.2);
  EXPECT_GT(coarse.scale_xy(), 1.2);
  EXPECT_GT(exact.information(step)(0, 0), 10.0 * coarse.information(step)(0, 0));
  EXPECT_GT(exact.information(step)(2, 2), 10.0 * coarse.information(step)(2, 2));
}

}  // namespace
}  // namespace ribbon_mapper::slam
