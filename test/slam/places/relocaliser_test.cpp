// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/places/relocaliser.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "modeler/geometry/angles.hpp"
#include "slam/tilting/trajectory_estimate.hpp"
#include "test/modeler/mini_world.hpp"

namespace ribbon_mapper::slam {
namespace {

using mini_world::Lines;

constexpr double kSlip_s = 13.0;

/// A room with a cupboard in a corner, so that no turn of the robot goes unseen.
mini_world::World furnished_room() {
  mini_world::World world = mini_world::room();
  world.push_back(mini_world::plane({-1, 0, 0}, 2.0, {2.0, 1.0, 0.0}, {2.0, 2.5, 2.0}));
  world.push_back(mini_world::plane({0, -1, 0}, 1.0, {2.0, 1.0, 0.0}, {3.0, 1.0, 2.0}));
  return world;
}

/// Returns the robot's true pose: it waits for 3 s and goes round.
Pose true_pose(double time_s) { return mini_world::around_the_middle(std::max(0.0, time_s - 3.0)); }

/// Returns an odometry that reports a motion at kSlip_s which the robot does not make.
mini_world::PoseByTime slip(double forward_m, double turn_deg) {
  Pose reported = Pose::Identity();
  reported.linear() =
      Eigen::AngleAxisd(turn_deg * kDegree, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  reported.translation().x() = forward_m;
  const Pose there = true_pose(kSlip_s);
  const Pose drift = there * reported * there.inverse(Eigen::Isometry);
  return [drift](double time_s) { return time_s < kSlip_s ? Pose::Identity() : drift; };
}

Lines lines_with(const mini_world::PoseByTime& drift, double to_s = 24.0) {
  return mini_world::drive(furnished_room(), {true_pose, mini_world::to_and_fro, drift}, 0.0, to_s);
}

/// An estimate of lines that were given one by one.
struct Estimated {
  explicit Estimated(const Lines& lines, const OdometrySource* source = nullptr)
      : modeler(ModelerConfig{}), estimate(modeler.observations(), estimate_settings({}), source) {
    for (const mini_world::Line& line : lines) {
      modeler.add_scan_line(line.beams, line.poses);
      estimate.update();
    }
  }
  /// Returns the error of the newest pose [m, deg].
  std::pair<double, double> error(const Lines& lines) const {
    const StampedPose last = estimate.trajectory().back();
    for (const StampedPose& truth : mini_world::true_trajectory(lines)) {
      if (truth.stamp != last.stamp) continue;
      const Pose error = truth.T_map_base.inverse(Eigen::Isometry) * last.T_map_base;
      return {error.translation().norm(), to_degrees(angle_of(error))};
    }
    return {1e9, 1e9};
  }
  std::size_t count(Decision::Kind kind) const {
    const auto& all = estimate.decisions();
    return static_cast<std::size_t>(std::count_if(
        all.begin(), all.end(), [&](const Decision& decision) { return decision.kind == kind; }));
  }
  Modeler modeler;
  TrajectoryEstimate estimate;
};

struct Slip {
  double forward_m, turn_deg;
};

class RelocaliserAfter : public testing::TestWithParam<Slip> {};

TEST_P(RelocaliserAfter, FindsTheRobot) {
  const Lines lines = lines_with(slip(GetParam().forward_m, GetParam().turn_deg));
  const Estimated run(lines);
  EXPECT_GE(run.count(Decision::Kind::found), 1U);
  EXPECT_FALSE(run.estimate.is_lost());
  const auto [distance_m, angle_deg] = run.error(lines);
  EXPECT_LT(distance_m, 0.03);
  EXPECT_LT(angle_deg, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Slips, RelocaliserAfter,
                         testing::Values(Slip{0.0, 20.0}, Slip{0.0, -15.0}, Slip{0.5, 0.0},
                                         Slip{-0.6, 0.0}, Slip{0.3, 12.0}));

/// A source that confirms the odometry, with an uncertainty of its own.
class Witness : public OdometrySource {
 public:
  explicit Witness(double variance) : variance_(variance) {}
  Pose T_odom_base(Time, const Pose& recorded) const override { return recorded; }
  Eigen::Matrix3d step_covariance(Time, Time, const Pose&) const override {
    return variance_ * Eigen::Matrix3d::Identity();
  }

 private:
  double variance_;
};

TEST(Relocaliser, BelievesASourceThatSawNoSlip) {
  const Lines lines = lines_with(slip(0.5, 0.0));
  const Witness certain(1e-6), blind(1.0);
  EXPECT_EQ(Estimated(lines, &certain).count(Decision::Kind::found), 0U);
  EXPECT_GE(Estimated(lines, &blind).count(Decision::Kind::found), 1U);
}

TEST(Relocaliser, SaysAtWhichLineAndWhyItMoved) {
  const Lines lines = lines_with(slip(0.0, 20.0));
  const Estimated run(lines);
  ASSERT_FALSE(run.estimate.decisions().empty());
  const Decision& found = run.estimate.decisions().back();
  EXPECT_EQ(found.kind, Decision::Kind::found);
  EXPECT_EQ(name_of(found.kind), "found");
  EXPECT_GT(to_seconds(found.stamp - lines.front().beams.stamp), kSlip_s);
  EXPECT_LT(to_seconds(found.stamp - lines.front().beams.stamp), kSlip_s + 10.0);
  EXPECT_NE(found.reason.find("degrees"), std::string::npos) << found.reason;
}

TEST(Decision, IsATextWithItsTimeNameAndReason) {
  const std::vector<Decision> decisions{{Decision::Kind::lost, from_seconds(7.2), "why"},
                                        {Decision::Kind::undone, from_seconds(9.0), "therefore"}};
  const std::vector<std::string> texts = texts_of(decisions, from_seconds(2.0));
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_EQ(texts[0], "5.2 s lost: why");
  EXPECT_EQ(texts[1], "7.0 s undone: therefore");
}

TEST(Relocaliser, DecidesNothingWhereNothingSlips) {
  const Estimated run(lines_with(mini_world::no_drift));
  EXPECT_TRUE(run.estimate.decisions().empty());
  EXPECT_FALSE(run.estimate.is_lost());
}

}  // namespace
}  // namespace ribbon_mapper::slam
