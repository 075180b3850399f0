// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/plane_landmarks.hpp"

#include <gtest/gtest.h>

#include "test/modeler/registration/walls.hpp"

namespace ribbon_mapper {
namespace {

using Eigen::Vector3d;

TEST(PlaneLandmarks, AreTheFacesWithAFrameOfTheirOwn) {
  Walls walls = one_wall();
  walls.add(3.0, 12);
  const PlaneLandmarks landmarks = walls.landmarks();
  ASSERT_EQ(2U, landmarks.all().size());
  for (int i = 0; i < 2; ++i) {
    const PlaneLandmark& wall = landmarks.all()[i];
    EXPECT_LT((wall.normal + Vector3d::UnitX()).norm(), 1e-4);
    EXPECT_NEAR(2.0 + i, wall.centroid.x(), 1e-4);
    EXPECT_NEAR(0.0, wall.axis_u.dot(wall.normal), 1e-9);
    EXPECT_LT((wall.normal.cross(wall.axis_u) - wall.axis_v).norm(), 1e-9);
  }
}

TEST(PlaneLandmarks, WithoutLinesOrRibbonsThereAreNone) {
  EXPECT_TRUE(Walls{}.landmarks().all().empty());
  Walls walls;
  walls.lines.resize(5);
  EXPECT_TRUE(walls.landmarks().all().empty());
}

TEST(PlaneLandmarks, NeedTheirNumberOfRibbons) {
  EXPECT_TRUE(one_wall(9).landmarks().all().empty());
  EXPECT_EQ(1U, one_wall(10).landmarks().all().size());
  RegistrationConfig config;
  config.min_ribbons = 9;
  EXPECT_EQ(1U, one_wall(9).landmarks(config).all().size());
}

TEST(PlaneLandmarks, RibbonsOfLinesThatAreNotLocalisedDoNotCount) {
  Walls walls = one_wall(12);
  for (int i = 0; i < 3; ++i) walls.lines[i].is_localised = false;
  EXPECT_TRUE(walls.landmarks().all().empty());
  walls.lines[0].is_localised = true;
  EXPECT_EQ(1U, walls.landmarks().all().size());
}

TEST(PlaneLandmarks, NeedSupportThatIsIndependentOfEachSegment) {
  Walls walls;
  walls.add(2.0, 15, 0U);
  EXPECT_TRUE(walls.landmarks().all().empty()) << "one segment may be wrong as a whole";
  walls.add(2.02, 4, 1U);
  walls.add(2.02, 5);
  EXPECT_TRUE(walls.landmarks().all().empty()) << "nine others";
  walls.add(2.02, 1, 2U);
  EXPECT_EQ(1U, walls.landmarks().all().size()) << "ten others";
}

TEST(PlaneLandmarks, AreFoundNearTheirRibbonsOnly) {
  const Walls walls = one_wall();
  PlaneLandmarks landmarks = walls.landmarks();
  const auto near = [&](const Ribbon& ribbon, const Pose& pose) {
    return landmarks.landmarks_near(PosedRibbon(ribbon, pose));
  };
  const std::vector<std::uint32_t> first{0}, none;
  const Ribbon on_it = Walls::ribbon_at(2.0, 0.7);
  EXPECT_EQ(first, near(on_it, Pose::Identity()));
  EXPECT_EQ(first, near(on_it, planar_pose(0.5, 0.0, 0.0))) << "drifted by half a metre";
  EXPECT_EQ(first, near(on_it, planar_pose(0.0, 0.0, 0.2))) << "whatever its direction";
  EXPECT_EQ(none, near(on_it, planar_pose(5.0, 0.0, 0.0)));
  EXPECT_EQ(none, near(on_it, planar_pose(0.0, -9.0, 0.0)));
}

}  // namespace
}  // namespace ribbon_mapper
