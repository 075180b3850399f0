// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the odometry reports against the motion that was made, without noise.
#include "sim/tour/odometry_faults.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/tour/localisation.hpp"

namespace ribbon_mapper::sim {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const Route kStraight(0.5, 0.5, {{0, 0}, {4, 0}});

Localisation exact(const Route& route, const std::string& faults) {
  LocalisationConfig config;
  config.drift = 0.0;
  config.faults = OdometryFaults::from(faults);
  return {route, config, 1};
}

/// Returns the motion by odometry from one time to another.
Pose motion(const Localisation& localisation, double from_s, double to_s) {
  return localisation.T_odom_base(from_seconds(from_s)).inverse() *
         localisation.T_odom_base(from_seconds(to_s));
}

/// Returns the motion that was truly made.
Pose true_motion(const Route& route, double from_s, double to_s) {
  return route.T_map_base(from_seconds(from_s)).inverse() * route.T_map_base(from_seconds(to_s));
}

TEST(OdometryFaults, ASlipIsATurnThatWasNotMade) {
  const Route standing(0.5, 0.5, {{0, 0}, {4, 0}}, 20.0);
  const Localisation slipped = exact(standing, "slip=10:-30");
  EXPECT_TRUE(motion(slipped, 0.0, 10.0).isApprox(Pose::Identity(), 1e-12));
  EXPECT_TRUE(motion(slipped, 0.0, 10.5).isApprox(planar_pose(0, 0, -30 * M_PI / 180), 1e-9));
  for (double t = 10.0; t < 10.3; t += 0.01)
    EXPECT_LE(std::abs(yaw_of(motion(slipped, t, t + 0.01))), 2.0 * 0.01 + 1e-9)
        << "wheels turn at most at 2 rad/s";
}

TEST(OdometryFaults, AShiftIsAWayThatWasNotMade) {
  const Localisation slipped = exact(kStraight, "shift=2:0.4");
  EXPECT_TRUE(motion(slipped, 0.0, 2.0).isApprox(true_motion(kStraight, 0.0, 2.0), 1e-9));
  EXPECT_NEAR(motion(slipped, 2.0, 3.0).translation().x(),
              true_motion(kStraight, 2.0, 3.0).translation().x() + 0.4, 1e-9);
  EXPECT_TRUE(motion(slipped, 3.0, 8.0).isApprox(true_motion(kStraight, 3.0, 8.0), 1e-9));
}

TEST(OdometryFaults, OfAPushNothingIsSeen) {
  const Localisation pushed = exact(kStraight, "push=2.005:1.5");
  EXPECT_TRUE(motion(pushed, 2.02, 3.5).isApprox(Pose::Identity(), 1e-9));
  EXPECT_NEAR(motion(pushed, 0.0, 8.0).translation().x(),
              true_motion(kStraight, 0.0, 8.0).translation().x() - 1.5 * 0.5, 1e-9)
      << "also with an end between two samples";
}

TEST(OdometryFaults, ScalesMultiplyWaysAndTurns) {
  const Route bend(0.5, 0.5, {{0, 0}, {3, 0}, {3, 2}});
  const double end_s = to_seconds(bend.duration());
  const Localisation scaled = exact(bend, "scale=1.1,yaw_scale=0.9");
  const double yaw_rad = 0.9 * M_PI / 2.0;
  const Pose end = motion(scaled, 0.0, end_s);
  EXPECT_NEAR(yaw_of(end), yaw_rad, 1e-9);
  EXPECT_NEAR(end.translation().x(), 1.1 * (3.0 + 2.0 * std::cos(yaw_rad)), 1e-6);
  EXPECT_NEAR(end.translation().y(), 1.1 * 2.0 * std::sin(yaw_rad), 1e-6);
}

/// The simulated SLAM follows the odometry: it is lost as well.
TEST(OdometryFaults, MoveTheBelievedPoseToo) {
  const Localisation slipped = exact(kStraight, "slip=2:20");
  const Time end = kStraight.duration();
  EXPECT_NEAR(yaw_of(slipped.T_map_odom(end) * slipped.T_odom_base(end)), 20 * M_PI / 180, 1e-9);
}

TEST(OdometryFaults, ChangeNoNoiseBeforeTheyHappen) {
  LocalisationConfig with;
  with.faults = OdometryFaults::from("slip=4:20,push=5:1");
  const Localisation noisy(kStraight, {}, 7), faulty(kStraight, with, 7);
  for (const double t : {0.0, 1.3, 3.9})
    EXPECT_EQ(noisy.T_odom_base(from_seconds(t)).matrix(),
              faulty.T_odom_base(from_seconds(t)).matrix());
  EXPECT_NE(noisy.T_odom_base(from_seconds(5.0)).matrix(),
            faulty.T_odom_base(from_seconds(5.0)).matrix());
}

TEST(OdometryFaults, AreRead) {
  const OdometryFaults faults =
      OdometryFaults::from("slip=30:20,shift=40:-0.5,push=60:2,scale=1.02,yaw_scale=0.97");
  ASSERT_EQ(faults.slips.size(), 2U);
  EXPECT_EQ(faults.slips[0].start_s, 30.0);
  EXPECT_NEAR(faults.slips[0].turn_rad, 20 * M_PI / 180, 1e-12);
  EXPECT_EQ(faults.slips[1].forward_m, -0.5);
  ASSERT_EQ(faults.pushes.size(), 1U);
  EXPECT_EQ(faults.pushes[0].duration_s, 2.0);
  EXPECT_EQ(faults.scale, 1.02);
  EXPECT_EQ(faults.yaw_scale, 0.97);
  EXPECT_TRUE(OdometryFaults::from("").slips.empty());
}

TEST(OdometryFaults, RefusesWhatIsNone) {
  const auto refused = [](const std::string& text, const std::string& why) {
    EXPECT_THAT([&] { OdometryFaults::from(text); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(why)))
        << text;
  };
  for (const char* text : {"slip", "slip=30", "slip=30:", "slip=:20", "slip=30:20x", "slide=3:2",
                           "scale=", "scale=nan", "slip=inf:2", "push=1:2,,scale=1", "slip=3:2:1"})
    refused(text, "use slip=T:DEGREES");
  refused("scale=2", "0.5..1.5");
  refused("yaw_scale=0", "yaw_scale must be in");
  refused("slip=-1:20", "0..14400 s");
  refused("slip=1:400", "-360..360 degrees");
  refused("shift=1:11", "-10..10 m");
  refused("slip=1:0", "must not be 0");
  refused("push=1:0", "must last");
}

}  // namespace
}  // namespace ribbon_mapper::sim
