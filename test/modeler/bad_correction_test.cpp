// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "modeler/modeler.hpp"
#include "test/modeler/plane_matchers.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;
using Trajectory = std::vector<StampedPose>;

/// A recording with drift and its model, for corrections that must be refused.
class BadCorrection : public ::testing::Test {
 protected:
  const Lines lines = drive(room(), {around_the_middle, to_and_fro, wandering_drift}, 0.0, 8.0);
  const Trajectory truth = true_trajectory(lines);
  Modeler modeler = model_of(lines);

  /// Expects that the trajectory is refused with these words and that nothing changes.
  void expect_refusal(const Trajectory& trajectory, const std::string& words) {
    const std::string planes = bytes_of(modeler.planes_as_built());
    const Pose last = modeler.trajectory().back().T_map_base;
    const std::size_t revision = modeler.statistics().revision;
    try {
      modeler.correct(trajectory);
      ADD_FAILURE() << "accepted, although " << words;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string::npos, std::string(error.what()).find(words)) << error.what();
    }
    EXPECT_EQ(planes, bytes_of(modeler.planes_as_built()));
    EXPECT_TRUE(last.isApprox(modeler.trajectory().back().T_map_base, 0.0));
    EXPECT_EQ(revision, modeler.statistics().revision);
  }

  void expect_bad_order_refused() {
    expect_refusal({}, "empty");
    Trajectory bad = truth;
    std::swap(bad[100], bad[101]);
    expect_refusal(bad, "do not increase at pose 101");
    bad = truth;
    std::reverse(bad.begin(), bad.end());
    expect_refusal(bad, "do not increase at pose 1");
    bad = truth;
    bad[50].stamp = bad[49].stamp;
    expect_refusal(bad, "do not increase at pose 50");
    bad = truth;
    for (StampedPose& pose : bad) pose.stamp = truth[0].stamp;
    expect_refusal(bad, "the stamp of its own time");
    for (const double hours : {-1.0, 1.0}) {
      bad = truth;
      for (StampedPose& pose : bad) pose.stamp += from_seconds(hours * 3600.0);
      expect_refusal(bad, "another run");
    }
  }

  void expect_bad_poses_refused() {
    Trajectory bad;
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      bad = truth;
      bad[7].T_map_base.translation().z() = value;
      expect_refusal(bad, "pose 7");
    }
    bad = truth;
    bad[8].T_map_base.linear().setZero();
    expect_refusal(bad, "pose 8");
  }
};

TEST_F(BadCorrection, LeavesTheModelUnchanged) {
  expect_bad_order_refused();
  expect_bad_poses_refused();
}

TEST_F(BadCorrection, LeavesACorrectedModelUnchanged) {
  modeler.correct(truth);
  expect_bad_order_refused();
  expect_bad_poses_refused();
}

/// Returns the recording with a robot that stands, as after an old latched path was received.
Lines standing() { return drive(room(), tilting_in_place(), 0.0, 6.0); }

/// A refused correction once destroyed the one before it: later lines got poses from freed memory.
TEST_F(BadCorrection, LeavesLaterLinesWhereTheLastGoodOnePutsThem) {
  for (const bool poses_follow : {true, false}) {
    ModelerConfig config;
    config.trajectory.poses_follow = poses_follow;
    const Lines all = standing();
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    Modeler refused = model_of({all.begin(), middle}, config);
    Modeler spared = model_of({all.begin(), middle}, config);
    const Trajectory moved{{all[all.size() / 4].beams.stamp, planar_pose(3.0, 4.0, 0.5)}};
    refused.correct(moved), spared.correct(moved);
    const Trajectory old_path{
        {all.front().beams.stamp - std::chrono::hours(1), planar_pose(110, 0, 0)}};
    const Trajectory absurd{{moved[0].stamp, planar_pose(1e19, 0.0, 0.0)}};
    for (const Trajectory& bad : {old_path, absurd, Trajectory()}) {
      EXPECT_THROW(refused.correct(bad), std::invalid_argument);
    }
    for (auto line = middle; line != all.end(); ++line) {
      refused.add_scan_line(line->beams, line->poses);
      spared.add_scan_line(line->beams, line->poses);
    }
    ASSERT_EQ(spared.trajectory().size(), refused.trajectory().size());
    for (std::size_t i = 0; i < refused.trajectory().size(); ++i) {
      EXPECT_TRUE(
          refused.trajectory()[i].T_map_base.isApprox(spared.trajectory()[i].T_map_base, 0.0));
    }
    EXPECT_EQ(bytes_of(spared.planes()), bytes_of(refused.planes()));
    refused.correct(moved), spared.correct(moved);
    EXPECT_EQ(bytes_of(spared.planes()), bytes_of(refused.planes()));
  }
}

TEST_F(BadCorrection, IsRefusedByAnEmptyModel) {
  Modeler empty{ModelerConfig{}};
  EXPECT_THROW(empty.correct(truth), std::invalid_argument);
  EXPECT_EQ(0u, empty.statistics().revision);
  for (const Line& line : lines) empty.add_scan_line(line.beams, line.poses);
  EXPECT_EQ(bytes_of(modeler.planes()), bytes_of(empty.planes()));
}

/// Other poses keep their odometry relative to the nearest corrected pose.
TEST_F(BadCorrection, MayCoverAPartOfTheRecording) {
  const Trajectory recorded = modeler.trajectory();
  const Trajectory part(truth.begin() + 100, truth.begin() + 200);
  modeler.correct(part);
  const auto at = [](const Trajectory& trajectory, Time stamp) {
    return std::find_if(trajectory.begin(), trajectory.end(),
                        [=](const StampedPose& pose) { return pose.stamp == stamp; })
        ->T_map_base;
  };
  const Pose first_change = part.front().T_map_base * at(recorded, part.front().stamp).inverse();
  const Pose last_change = part.back().T_map_base * at(recorded, part.back().stamp).inverse();
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    const Time stamp = recorded[i].stamp;
    const Pose expected = stamp < part.front().stamp  ? first_change * recorded[i].T_map_base
                          : stamp > part.back().stamp ? last_change * recorded[i].T_map_base
                                                      : at(truth, stamp);
    EXPECT_LT((expected.matrix() - modeler.trajectory()[i].T_map_base.matrix()).norm(), 1e-9);
  }
}

TEST_F(BadCorrection, MayContainPosesOutsideTheRecording) {
  Trajectory longer = truth;
  longer.insert(longer.begin(), {truth[0].stamp - from_seconds(100.0), planar_pose(99, 99, 1)});
  longer.push_back({truth.back().stamp + from_seconds(100.0), planar_pose(-99, 99, 1)});
  Modeler other = model_of(lines);
  modeler.correct(truth);
  other.correct(longer);
  EXPECT_EQ(bytes_of(modeler.planes()), bytes_of(other.planes()));
}

}  // namespace
}  // namespace ribbon_mapper
