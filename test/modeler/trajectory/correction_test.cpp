// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/trajectory/correction.hpp"

#include <gtest/gtest.h>

#include <random>

#include "modeler/trajectory/trajectory.hpp"
#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {
namespace {

using Poses = std::vector<StampedPose>;

/// Returns a winding path of 10 s with a pose every 0.1 s.
Poses winding_path() {
  std::mt19937 random(6);
  std::normal_distribution<double> step(0.0, 0.05);
  Poses poses;
  Pose pose = planar_pose(3.0, 4.0, 0.5);
  for (int i = 0; i <= 100; ++i) {
    poses.push_back({from_seconds(100.0 + 0.1 * i), pose});
    pose = pose * planar_pose(0.05 + step(random), step(random), step(random));
  }
  return poses;
}

/// Returns the pose as recorded with a localisation that never jumps: map and odom coincide.
TrackedPose recorded_as(const StampedPose& pose) { return {pose, pose.T_map_base}; }

TrackedPoses recorded_as(const Poses& poses) {
  TrackedPoses recorded;
  for (const StampedPose& pose : poses) recorded.push_back(recorded_as(pose));
  return recorded;
}

double distance(const Pose& a, const Pose& b) { return (a.matrix() - b.matrix()).norm(); }

TEST(Correction, IsExactAtTheCorrectedPoses) {
  const Poses recorded = winding_path();
  Poses corrected;
  for (int i = 5; i < 100; i += 13) {
    corrected.push_back({recorded[i].stamp, planar_pose(0.1 * i, -i, 0.02 * i)});
  }
  const Correction correction(recorded_as(recorded), corrected);
  for (int i = 5, k = 0; i < 100; i += 13, ++k) {
    EXPECT_LT(distance(corrected[k].T_map_base, correction.corrected(recorded_as(recorded[i]))),
              1e-12);
  }
}

TEST(Correction, InterpolatesTheChangeNotThePose) {
  const Poses recorded = winding_path();
  Poses corrected{recorded[20], recorded[60]};
  corrected[1].T_map_base = Eigen::Translation3d(0.4, -0.8, 0.0) * corrected[1].T_map_base;
  const Correction correction(recorded_as(recorded), corrected);
  for (int i = 20; i <= 60; ++i) {
    const double share = (i - 20) / 40.0;
    const Pose expected =
        Eigen::Translation3d(0.4 * share, -0.8 * share, 0.0) * recorded[i].T_map_base;
    EXPECT_LT(distance(expected, correction.corrected(recorded_as(recorded[i]))), 1e-9);
  }
}

TEST(Correction, AppliesTheNearestChangeBeyondItsEnds) {
  const Poses recorded = winding_path();
  const Pose first = planar_pose(1.0, 2.0, 0.3), last = planar_pose(-2.0, 1.0, -0.4);
  const Correction correction(recorded_as(recorded),
                              {{recorded[40].stamp, first * recorded[40].T_map_base},
                               {recorded[50].stamp, last * recorded[50].T_map_base}});
  for (int i = 0; i < 40; ++i) {
    EXPECT_LT(
        distance(first * recorded[i].T_map_base, correction.corrected(recorded_as(recorded[i]))),
        1e-9);
  }
  for (int i = 51; i <= 100; ++i) {
    EXPECT_LT(
        distance(last * recorded[i].T_map_base, correction.corrected(recorded_as(recorded[i]))),
        1e-9);
  }
}

TEST(Correction, ComparesPosesBetweenRecordedOnesWithTheRecordedPath) {
  const Poses recorded = winding_path();
  const Pose T = planar_pose(0.5, 0.2, 0.1);
  Poses corrected;
  for (int i = 0; i < 100; i += 7) {
    const Pose between = interpolate(recorded[i].T_map_base, recorded[i + 1].T_map_base, 0.25);
    corrected.push_back({recorded[i].stamp + from_seconds(0.025), T * between});
  }
  const Correction correction(recorded_as(recorded), corrected);
  for (const StampedPose& pose : recorded) {
    EXPECT_LT(distance(T * pose.T_map_base, correction.corrected(recorded_as(pose))), 1e-9);
  }
}

TEST(Trajectory, IsCorrectedFromTheRecordedPosesEachTime) {
  Trajectory trajectory({});
  const Poses recorded = winding_path();
  for (const StampedPose& pose : recorded) trajectory.add(recorded_as(pose));
  EXPECT_FALSE(trajectory.is_corrected());
  const Pose T = planar_pose(5.0, 6.0, 1.0);
  for (int i = 0; i < 3; ++i) {
    trajectory.correct({{recorded[10].stamp, T * recorded[10].T_map_base}});
    EXPECT_TRUE(trajectory.is_corrected());
    EXPECT_LT(distance(T * recorded[77].T_map_base, trajectory.poses()[77].T_map_base), 1e-9);
    EXPECT_LT(distance(recorded[77].T_map_base, trajectory.recorded()[77].in_map.T_map_base),
              1e-12);
  }
}

TEST(PosedRibbon, EqualsTheRibbonOfMovedPointsInSinglePrecision) {
  const Pose T = Eigen::Translation3d(4.0, -1.0, 0.3) *
                 Eigen::AngleAxisd(1.2, Eigen::Vector3d(2, -1, 1).normalized());
  const Eigen::Vector3d from(2.0, 0.5, 0.1), to(2.0, -0.7, 0.1), normal(-1.0, 0.0, 0.0);
  const Ribbon here = mini_world::ribbon_between(from, to, normal);
  const Ribbon there = mini_world::ribbon_between(T * from, T * to, T.linear() * normal);
  const PosedRibbon moved(here, T), same(there, Pose::Identity());
  EXPECT_LT((same.centroid - moved.centroid).norm(), 1e-6);
  EXPECT_LT((same.normal - moved.normal).norm(), 1e-6);
  EXPECT_LT((same.along - moved.along).norm(), 1e-6);
  EXPECT_LT((same.across - moved.across).norm(), 1e-6);
  EXPECT_LT((same.moments.covariance() - moved.moments.covariance()).norm(), 1e-6);
}

}  // namespace
}  // namespace ribbon_mapper
