// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A robot on ramps: its pose against that of its casters on the ground.
#include "sim/tour/ground_profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/robot/pr2.hpp"
#include "sim/tour/localisation.hpp"
#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kSlope = 0.05;

/// Up 0.1 m over 2 m along y, over a platform of 2 m, and down.
const std::vector<Eigen::Vector2d> kWay{{1, 0}, {1, 2}, {1, 4}, {1, 6}, {1, 8}, {1, 10}};
const std::vector<double> kHeights_m{0.0, 0.0, 0.1, 0.1, 0.0, 0.0};
const Route kRoute(0.5, 0.5, kWay, 0.0, kHeights_m);

double ground_m(double y_m) {
  return std::clamp(std::min(kSlope * (y_m - 2.0), kSlope * (8.0 - y_m)), 0.0, 0.1);
}

TEST(GroundProfile, IsLinearFromWaypointToWaypoint) {
  const GroundProfile profile({0.0, 1.0, 3.0}, {0.2, 0.2, 0.0});
  EXPECT_DOUBLE_EQ(profile.height_m(-1.0), 0.2);
  EXPECT_DOUBLE_EQ(profile.height_m(0.5), 0.2);
  EXPECT_DOUBLE_EQ(profile.height_m(2.0), 0.1);
  EXPECT_DOUBLE_EQ(profile.height_m(9.0), 0.0);
  EXPECT_TRUE(profile.is_level_at(0.5));
  EXPECT_FALSE(profile.is_level_at(0.9)) << "the front casters stand on the slope";
  EXPECT_FALSE(profile.is_level());
  EXPECT_TRUE(GroundProfile().is_level());
}

TEST(GroundProfile, BothCastersStandOnTheGround) {
  int on_slope = 0;
  for (Time t(0); t < kRoute.duration(); t += std::chrono::milliseconds(20)) {
    const Pose T_map_base = kRoute.T_map_base(t);
    EXPECT_TRUE(is_valid(T_map_base));
    EXPECT_NEAR(T_map_base.linear()(0, 0), 0.0, 1e-12) << "looks along y";
    for (const double x_m : {-pr2::kCasters_m, pr2::kCasters_m}) {
      const Eigen::Vector3d caster = T_map_base * Eigen::Vector3d(x_m, 0.0, 0.0);
      EXPECT_NEAR(caster.z(), ground_m(caster.y()), 1e-4) << caster.y();
    }
    on_slope += std::abs(T_map_base(2, 0)) > 0.049 ? 1 : 0;
  }
  EXPECT_GT(on_slope, 200);
}

TEST(GroundProfile, LooksUpOnTheWayUp) {
  const double y_m = 3.0;
  for (Time t(0); t < kRoute.duration(); t += std::chrono::milliseconds(20)) {
    const Pose T_map_base = kRoute.T_map_base(t);
    if (std::abs(T_map_base.translation().y() - y_m) > 0.01) continue;
    EXPECT_NEAR(T_map_base(2, 0), std::sin(std::atan(kSlope)), 1e-9);
    return;
  }
  FAIL() << "never there";
}

TEST(GroundProfile, LevelHeightsChangeNoPose) {
  const Route flat(0.5, 0.5, kWay), level(0.5, 0.5, kWay, 0.0, std::vector<double>(6, 0.0));
  for (Time t(0); t < flat.duration(); t += std::chrono::milliseconds(170))
    EXPECT_EQ(flat.T_map_base(t).matrix(), level.T_map_base(t).matrix());
}

/// robot_pose_ekf: pitch by the IMU, height 0.
TEST(GroundProfile, TheOdometryHasThePitchButNotTheHeight) {
  LocalisationConfig exact;
  exact.drift = 0.0;
  const Localisation localisation(kRoute, exact, 1);
  for (Time t(0); t < kRoute.duration(); t += std::chrono::milliseconds(170)) {
    const Pose T_odom_base = localisation.T_odom_base(t), T_map_base = kRoute.T_map_base(t);
    EXPECT_NEAR(T_odom_base.translation().z(), 0.0, 1e-4);
    EXPECT_NEAR(T_odom_base(2, 0), T_map_base(2, 0), 1e-6);
    EXPECT_NEAR(T_odom_base.translation().x(), T_map_base.translation().y(), 1e-3);
  }
}

TEST(GroundProfile, TheLaserLooksAlongTheSlope) {
  for (const double pitch_rad : {-0.05, 0.05}) {
    const Pose T_map_base =
        planar_pose(1.0, 2.0, 0.4) * Pose(Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()));
    EXPECT_TRUE(
        pr2::T_map_laser(T_map_base, 0.3).isApprox(T_map_base * pr2::T_base_laser(0.3), 1e-12));
  }
}

TEST(GroundProfile, RefusesWhatAPr2CannotDrive) {
  const auto made = [](std::vector<Eigen::Vector2d> way, std::vector<double> heights_m) {
    return [=] { Route(0.5, 0.5, way, 0.0, heights_m); };
  };
  const auto says = [](const char* text) {
    return ThrowsMessage<std::invalid_argument>(HasSubstr(text));
  };
  EXPECT_THAT(made({{0, 0}, {1, 0}}, {0.0, 0.11}), says("slope to waypoint 2 is above 0.1"));
  EXPECT_THAT(made({{0, 0}, {1, 0}, {1, 1}}, {0.0, 0.05, 0.05}), says("turns on a slope"));
  EXPECT_THAT(made({{0, 0}, {1, 0}}, {0.0}), says("each waypoint needs a height"));
  EXPECT_THAT(made({{0, 0}, {1, 0}}, {0.0, NAN}), says("heights must be finite"));
  EXPECT_THAT(made({{0, 0}, {4, 0}, {0, 0}}, {0.0, 0.0, 0.2}), says("but not their heights"));
}

TEST(GroundProfile, HeightsMustBeThoseOfTheWorld) {
  const World world = world_of(sdf_block("floor", {-1, -1, -0.1}, {3, 11, 0}));
  EXPECT_NO_THROW(require_free(world, Route(0.5, 0.5, kWay)));
  EXPECT_THAT([&] { require_free(world, kRoute); },
              ThrowsMessage<std::runtime_error>(HasSubstr("does not fit the ground at x 1.00")));
}

}  // namespace
}  // namespace ribbon_mapper::sim
