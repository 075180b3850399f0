// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/observations/observations.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;
using Vector = Eigen::Vector3d;

/// Returns the recorded pose of line `i`: a metre further along x each second.
TrackedPose pose_of(int i) {
  const Pose T_map_base = planar_pose(1.0 * i, 0.0, 0.0);
  return {{from_seconds(1.0 + i), T_map_base}, T_map_base};
}

/// Returns observations of `lines` lines with two ribbons each; no place is seen twice.
Observations observations_of(int lines, const TrajectoryConfig& config = {}) {
  Observations observations(config);
  for (int i = 0; i < lines; ++i) {
    LineObservations line;
    line.ribbons = {ribbon_between({0, 0, 0}, {1, 0, 0}, Vector::UnitZ()),
                    ribbon_between({0, 5, 0}, {1, 5, 0}, Vector::UnitZ())};
    const PackedPoint point{{1, 2, static_cast<std::int16_t>(i)}, 3};
    line.unassigned.first = &point;
    line.unassigned.size = 1;
    observations.add_line(pose_of(i), line);
  }
  return observations;
}

/// Expects that ribbons, unassigned points and poses refer to each other.
void expect_in_step(const Observations& observations) {
  const std::size_t poses = observations.trajectory().size();
  ASSERT_EQ(poses, observations.unassigned().size());
  for (std::size_t i = 0; i < poses; ++i) {
    ASSERT_EQ(i, observations.unassigned()[i].pose);
    ASSERT_EQ(1u, observations.unassigned()[i].size);
  }
  for (const Ribbon& ribbon : observations.ribbons()) {
    ASSERT_LT(ribbon.pose, poses);
    ASSERT_NEAR(1.0F, ribbon.samples.length_m(), 0.05F);
  }
}

TEST(Observations, CopyWhatALineRefersTo) {
  const Observations observations = observations_of(3);
  expect_in_step(observations);
  ASSERT_EQ(6u, observations.ribbons().size());
  for (std::uint32_t i = 0; i < 6; ++i) EXPECT_EQ(i / 2, observations.ribbons()[i].pose);
  for (std::int16_t i = 0; i < 3; ++i) {
    EXPECT_EQ(i, observations.unassigned()[static_cast<std::size_t>(i)].begin()->from_sensor[2]);
  }
}

TEST(Observations, ReturnTheIndexOfALinesFirstRibbon) {
  Observations observations = observations_of(2);
  EXPECT_EQ(4u, observations.add_line(pose_of(2), {}));
  EXPECT_EQ(4u, observations.add_line(pose_of(3), {}));
}

TEST(Observations, ArePosedRelativeToTheFirstPose) {
  Observations observations = observations_of(3);
  EXPECT_TRUE(observations.T_model_base(0).isApprox(Pose::Identity(), 1e-12));
  const PosedObservations posed = observations.posed();
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(posed.T_model_base(i).isApprox(observations.T_model_base(i), 1e-12));
    EXPECT_NEAR(0.5 + i, posed.ribbon(2 * i).centroid.x(), 1e-5);
  }
}

TEST(Observations, FollowACorrectionAndLeaveRibbonsAsTheyWere) {
  Observations observations = observations_of(3);
  const Vector before = observations.ribbons()[4].moments.mean();
  std::vector<StampedPose> corrected;
  for (int i = 0; i < 3; ++i) {
    corrected.push_back({pose_of(i).in_map.stamp, planar_pose(2.0 * i, 0.0, 0.0)});
  }
  observations.correct(corrected);
  EXPECT_NEAR(4.5, observations.posed().ribbon(4).centroid.x(), 1e-5);
  EXPECT_EQ(before, observations.ribbons()[4].moments.mean());
  expect_in_step(observations);
}

TEST(Observations, KeepAnEarlierCorrectionWhenOneIsRefused) {
  TrajectoryConfig config;
  config.poses_follow = false;  // later lines are moved by the last change
  Observations observations = observations_of(3, config);
  observations.correct({{pose_of(2).in_map.stamp, planar_pose(2.0, 7.0, 0.0)}});
  const std::vector<StampedPose> another_run{{from_seconds(1e6), Pose::Identity()}};
  EXPECT_THROW(observations.correct(another_run), std::invalid_argument);
  observations.add_line(pose_of(3), {});
  EXPECT_TRUE(observations.trajectory().T_map_base(3).isApprox(planar_pose(3.0, 7.0, 0.0), 1e-9));
  EXPECT_TRUE(observations.trajectory().T_map_base(0).isApprox(planar_pose(0.0, 7.0, 0.0), 1e-9));
}

TEST(Observations, RemoveLinesWithoutRibbonsWhenThinned) {
  Observations observations = observations_of(20);
  const std::vector<std::uint32_t> kept = observations.thin(10);
  ASSERT_EQ(10u, kept.size());
  ASSERT_EQ(10u, observations.ribbons().size());
  expect_in_step(observations);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Ribbon& ribbon = observations.ribbons()[i];
    const auto former_pose = static_cast<int>(kept[i] / 2);
    EXPECT_EQ(pose_of(former_pose).in_map.stamp,
              observations.trajectory().recorded().stamps()[ribbon.pose]);
    EXPECT_EQ(former_pose, observations.unassigned()[ribbon.pose].begin()->from_sensor[2]);
  }
}

TEST(Observations, MoveToAnotherTrajectoryOfTheSameLines) {
  Observations observations = observations_of(3);
  Trajectory trajectory = observations.trajectory();
  trajectory.correct({{pose_of(0).in_map.stamp, planar_pose(0.0, 7.0, 0.0)}});
  EXPECT_NEAR(0.5, observations.posed().ribbon(0).centroid.x(), 1e-5);
  EXPECT_NEAR(7.0, observations.posed_at(trajectory).T_map_model().translation().y(), 1e-9);
  EXPECT_NEAR(0.0, observations.posed().T_map_model().translation().y(), 1e-9);
  observations.move_to(std::move(trajectory));
  EXPECT_NEAR(7.0, observations.posed().T_map_model().translation().y(), 1e-9);
  expect_in_step(observations);
}

TEST(Observations, ReleaseTheMemoryOfWhatWasRemoved) {
  Observations observations = observations_of(20);
  const std::size_t before = observations.memory_bytes();
  observations.thin(4);
  EXPECT_LE(observations.memory_bytes(), before);
}

}  // namespace
}  // namespace ribbon_mapper
