// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/offline/trajectory_notes.hpp"

#include <gmock/gmock.h>

namespace ribbon_mapper {
namespace {

/// Returns a pose for each second of [from, to], `step_m` apart along x.
std::vector<StampedPose> poses(int from_s, int to_s, double step_m) {
  std::vector<StampedPose> result;
  for (int s = from_s; s <= to_s; ++s) {
    result.push_back({from_seconds(s), Pose(Eigen::Translation3d(s * step_m, 0.0, 0.0))});
  }
  return result;
}

TEST(TrajectoryNotes, ATrajectoryThatEndsEarlyIsAWarning) {
  const auto lines = poses(100, 200, 0.1);
  const auto text = lacking_time(lines, poses(90, 150, 0.1));
  ASSERT_TRUE(text);
  EXPECT_THAT(*text, testing::HasSubstr("covers 50.0 s of the 100.0 s of the lines"));
  EXPECT_FALSE(lacking_time(lines, lines));
  EXPECT_FALSE(lacking_time(lines, poses(90, 210, 0.1)));
  EXPECT_FALSE(lacking_time(lines, poses(102, 198, 0.1))) << "a keyframe may come late";
  EXPECT_FALSE(lacking_time(lines, {})) << "there is none";
}

TEST(TrajectoryNotes, TheLargestMoveIsThatOfOnePose) {
  EXPECT_DOUBLE_EQ(20.0, largest_move_m(poses(100, 200, 0.1), poses(100, 200, 0.2)));
  EXPECT_EQ(0.0, largest_move_m({}, {}));
}

TEST(TrajectoryNotes, ABaseStandsStillWithinAMillimetre) {
  EXPECT_TRUE(stands_still(poses(0, 9, 0.0001)));
  EXPECT_FALSE(stands_still(poses(0, 9, 0.001)));
}

}  // namespace
}  // namespace ribbon_mapper
