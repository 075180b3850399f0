// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/matching/scan_matcher.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "test/slam/matching/wall_world.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr double kWidth_m = 0.08, kGate_m = 0.3;

/// Returns a map in the frame of the world, seen from several places.
SurfaceMap map_of(const WallWorld& world) {
  LevelPoints points;
  for (const double x : {-0.6, 0.0, 0.6}) {
    const PlanarPose pose{x, 0.3 * x, 0.5 * x};
    append_moved(world.scan(pose, 1.0, true).points, pose, points);
  }
  return SurfaceMap(points);
}

TEST(SurfaceMap, KnowsDistanceAndNormalOfAWall) {
  const SurfaceMap map = map_of(WallWorld::square());
  const auto tangent = map.near({2.95F, 0.4F, -1.0F, 0.0F}, kWidth_m, kGate_m);
  ASSERT_TRUE(tangent);
  EXPECT_NEAR(tangent->distance_m, 0.05, 1e-3);
  EXPECT_NEAR(tangent->normal_x, -1.0, 1e-3);
  EXPECT_FALSE(map.near({2.95F, 0.4F, 1.0F, 0.0F}, kWidth_m, kGate_m)) << "its other side";
  EXPECT_FALSE(map.near({2.0F, 0.4F, -1.0F, 0.0F}, kWidth_m, kGate_m)) << "too far";
  EXPECT_FALSE(map.near({1e6F, 0.4F, -1.0F, 0.0F}, kWidth_m, kGate_m)) << "outside";
}

TEST(SurfaceMap, MayBeEmpty) {
  const SurfaceMap map(LevelPoints{});
  EXPECT_TRUE(map.empty());
  EXPECT_FALSE(map.near({0.0F, 0.0F, 1.0F, 0.0F}, kWidth_m, kGate_m));
}

TEST(Misfit, GradientIsThatOfTheResidualsByFiniteDifferences) {
  // near the true pose all weights are 1, and the residuals are linear: the gradient is their
  // derivative times their size
  const WallWorld world = WallWorld::room();
  const SurfaceMap map = map_of(world);
  const PlanarPose truth{0.2, -0.1, 0.3};
  const LevelPoints points = world.scan(truth).points;
  const Eigen::Matrix3d H = misfit_at(points, map, truth, MatchStage{}, {}).hessian;
  const Eigen::Vector3d g0 = misfit_at(points, map, truth, MatchStage{}, {}).gradient;
  const double step = 5e-4;
  for (int i = 0; i < 3; ++i) {
    Eigen::Vector3d moved = truth.vector();
    moved(i) += step;
    const Eigen::Vector3d g = misfit_at(points, map, planar(moved), MatchStage{}, {}).gradient;
    const Eigen::Vector3d slope = (g - g0) / step;
    EXPECT_LT((slope - H.col(i)).norm(), 0.05 * H.col(i).norm()) << i;
  }
}

TEST(Match, FindsThePoseInARoom) {
  const WallWorld world = WallWorld::room();
  const SurfaceMap map = map_of(world);
  const PlanarPose truth{0.2, -0.1, 0.3};
  const LevelPoints points = world.scan(truth).points;
  for (const PlanarPose& off : {PlanarPose{0.15, 0.1, 0.05}, PlanarPose{-0.1, 0.15, -0.05}}) {
    const Match found = match(points, map, truth * off, std::nullopt, {});
    EXPECT_LT(distance_m(found.T_map_base, truth), 0.005);
    EXPECT_NEAR(found.T_map_base.yaw_rad, truth.yaw_rad, 0.002);
    EXPECT_GT(found.agreeing, 0.9);
  }
}

/// Returns points whose normals err by 0.04 rad.
LevelPoints with_wrong_normals(LevelPoints points) {
  std::mt19937 random(1);
  std::normal_distribution<float> turn(0.0F, 0.04F);
  for (LevelPoint& p : points) {
    const float c = std::cos(turn(random)), s = std::sin(turn(random));
    const float x = p.normal_x;
    p.normal_x = c * x - s * p.normal_y, p.normal_y = s * x + c * p.normal_y;
  }
  return points;
}

/// Returns a match at the truth against surfaces whose normals err.
Match match_with_wrong_normals(const WallWorld& world) {
  const LevelPoints points = world.scan({}, 1.0, true).points;
  return match(points, SurfaceMap(with_wrong_normals(points)), {}, std::nullopt, {});
}

TEST(InformationBeyondNormals, IsNoneAlongACorridorAndAllAcrossIt) {
  const Match found = match_with_wrong_normals(WallWorld::corridor());
  ASSERT_GT(found.information(0, 0), 1e-4 * found.information(1, 1)) << "it is feigned";
  const Eigen::Matrix3d left = information_beyond_normals(found, {});
  EXPECT_LT(left(0, 0), 0.1 * found.information(0, 0));
  EXPECT_GT(left(1, 1), 0.95 * found.information(1, 1));
  EXPECT_GT(left(2, 2), 0.95 * found.information(2, 2));
}

TEST(InformationBeyondNormals, IsThatOfTheMatchInARoom) {
  const Match found = match_with_wrong_normals(WallWorld::room());
  const Eigen::Matrix3d left = information_beyond_normals(found, {});
  EXPECT_LT((left - found.information).norm(), 0.02 * found.information.norm());
}

TEST(Match, KeepsToItsPriorAlongACorridor) {
  const WallWorld world = WallWorld::corridor();
  const SurfaceMap map = map_of(world);
  PosePrior prior{{0.4, 0.1, 0.02}, Eigen::Vector3d(100.0, 100.0, 400.0).asDiagonal()};
  const Match found = match(world.scan({}).points, map, prior.T_map_base, prior, {});
  EXPECT_NEAR(found.T_map_base.x_m, 0.4, 0.02) << "what the walls leave open";
  EXPECT_NEAR(found.T_map_base.y_m, 0.0, 0.005);
  EXPECT_NEAR(found.T_map_base.yaw_rad, 0.0, 0.002);
  EXPECT_LT(found.information(0, 0), 0.01 * found.information(1, 1));
}

TEST(Match, ClutterDoesNotPull) {
  const WallWorld world = WallWorld::room();
  const SurfaceMap map = map_of(world);
  LevelPoints points = world.scan({}).points;
  for (std::size_t i = 0; i < points.size(); i += 4) points[i].x_m -= 0.12F;  // a quarter of them
  const Match found = match(points, map, {0.05, 0.05, 0.0}, std::nullopt, {});
  EXPECT_LT(distance_m(found.T_map_base, {}), 0.01);
}

TEST(Match, WithoutPointsOrMapIsTheGuess) {
  const PlanarPose guess{1.0, 2.0, 0.5};
  const Match found = match({}, SurfaceMap(LevelPoints{}), guess, std::nullopt, {});
  EXPECT_EQ(found.points, 0);
  EXPECT_LT(distance_m(found.T_map_base, guess), 1e-12);
}

}  // namespace
}  // namespace ribbon_mapper::slam
