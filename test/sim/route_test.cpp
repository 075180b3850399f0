// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/tour/route.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/robot/pr2.hpp"
#include "test/sim/sample_world.hpp"

namespace ribbon_mapper::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kPi = 3.14159265358979323846;

double duration_s(const Route& route) { return to_seconds(route.duration()); }

/// Duration from rest to rest: that of a cruise plus one ramp, at the PR2's limits of 2 m/s2 and
/// 2 rad/s2.
double ramped_s(double way, double speed) { return way / speed + speed / 2.0; }

TEST(Route, StraightDriveTakesWayOverSpeedAndARamp) {
  const Route route(0.3, 0.6, {{1, 2}, {4, 2}});
  EXPECT_NEAR(duration_s(route), ramped_s(3.0, 0.3), 1e-8);
  EXPECT_DOUBLE_EQ(route.length_m(), 3.0);
  const Pose middle = route.T_map_base(route.duration() / 2);
  EXPECT_NEAR(middle.translation().x(), 2.5, 1e-8);
  EXPECT_NEAR(yaw_of(middle), 0.0, 1e-12);
  EXPECT_NEAR(route.velocity(route.duration() / 2).forward_m_s, 0.3, 1e-12);
}

TEST(Route, AShortDriveNeverReachesItsSpeed) {
  const Route route(1.0, 0.6, {{0, 0}, {0.1, 0}});
  EXPECT_NEAR(duration_s(route), 2.0 * std::sqrt(0.1 / 2.0), 1e-8);
  EXPECT_NEAR(route.velocity(route.duration() / 2).forward_m_s, std::sqrt(0.1 * 2.0), 1e-6);
}

TEST(Route, TurnsTakeAngleOverRateAndARampTheShorterWayRound) {
  for (const double yaw_rad : {0.5 * kPi, -0.5 * kPi, 0.9 * kPi, -0.9 * kPi}) {
    const Eigen::Vector2d bend(2, 0),
        end = bend + Eigen::Vector2d(std::cos(yaw_rad), std::sin(yaw_rad));
    const Route route(0.5, 0.8, {{0, 0}, bend, end});
    const double expected_s =
        ramped_s(2, 0.5) + ramped_s(std::abs(yaw_rad), 0.8) + ramped_s(1, 0.5);
    EXPECT_NEAR(duration_s(route), expected_s, 1e-7);
    const Velocity turning =
        route.velocity(from_seconds(ramped_s(2, 0.5) + ramped_s(std::abs(yaw_rad), 0.8) / 2.0));
    EXPECT_NEAR(turning.turn_rad_s, std::copysign(0.8, yaw_rad), 1e-9);
    EXPECT_EQ(turning.forward_m_s, 0.0);
    EXPECT_NEAR(yaw_of(route.T_map_base(route.duration())), yaw_rad, 1e-9);
  }
}

TEST(Route, AClosedRouteEndsAsItBegan) {
  const Route route(0.4, 0.7, {{0, 0}, {2, 0}, {2, 1}, {0, 0}});
  EXPECT_TRUE(route.closed());
  EXPECT_TRUE(route.T_map_base(route.duration()).isApprox(route.T_map_base(Time(0)), 1e-9));
}

TEST(Route, RestsBeforeItStarts) {
  const Route at_once(0.4, 0.7, {{0, 0}, {2, 1}}), rested(0.4, 0.7, {{0, 0}, {2, 1}}, 5.0);
  EXPECT_NEAR(duration_s(rested), duration_s(at_once) + 5.0, 1e-8);
  EXPECT_TRUE(rested.T_map_base(from_seconds(4.99)).isApprox(rested.T_map_base(Time(0)), 1e-12));
  EXPECT_EQ(rested.velocity(from_seconds(4.99)).forward_m_s, 0.0);
  for (const double t : {0.3, 2.0, 4.0})
    EXPECT_TRUE(rested.T_map_base(from_seconds(5.0 + t))
                    .isApprox(at_once.T_map_base(from_seconds(t)), 1e-6))
        << t;
  EXPECT_NEAR(duration_s(rested.at_speed(0.8)) - duration_s(at_once.at_speed(0.8)), 5.0, 1e-8);
  EXPECT_THROW(Route(0.4, 0.7, {{0, 0}, {2, 1}}, -1.0), std::invalid_argument);
  EXPECT_THROW(Route(0.4, 0.7, {{0, 0}, {2, 1}}, 1001.0), std::invalid_argument);
}

TEST(Route, StandsBeforeItsStartAndAfterItsEnd) {
  const Route route(0.4, 0.7, {{0, 0}, {2, 1}});
  EXPECT_TRUE(route.T_map_base(Time(-1)).isApprox(route.T_map_base(Time(0))));
  const Time late = route.duration() + from_seconds(100.0);
  EXPECT_NEAR((route.T_map_base(late).translation() - Eigen::Vector3d(2, 1, 0)).norm(), 0.0, 1e-9);
  EXPECT_EQ(route.velocity(late).forward_m_s, 0.0);
}

/// The velocity is the derivative of the pose and respects the route's and the PR2's limits.
TEST(Route, VelocityIsTheDerivativeOfThePose) {
  const Route route(0.45, 0.65, {{0, 0}, {2, 0.5}, {1, 2}, {-1, 1}, {0, 0}});
  const double step_s = 1e-3;
  Velocity before;
  for (double t = step_s; t < duration_s(route) - step_s; t += step_s) {
    const Pose a = route.T_map_base(from_seconds(t - step_s / 2)),
               b = route.T_map_base(from_seconds(t + step_s / 2));
    const Velocity v = route.velocity(from_seconds(t));
    const Pose change = a.inverse() * b;
    EXPECT_NEAR(change.translation().x() / step_s, v.forward_m_s, 1.1e-3);
    EXPECT_NEAR(change.translation().y(), 0.0, 1e-9) << "it drives straight ahead only";
    EXPECT_NEAR(yaw_of(change) / step_s, v.turn_rad_s, 1.1e-3);
    EXPECT_LE(v.forward_m_s, 0.45 + 1e-12);
    EXPECT_LE(std::abs(v.turn_rad_s), 0.65 + 1e-12);
    EXPECT_LE(std::abs(v.forward_m_s - before.forward_m_s), 2.0 * step_s + 1e-9);
    EXPECT_LE(std::abs(v.turn_rad_s - before.turn_rad_s), 2.0 * step_s + 1e-9);
    before = v;
  }
}

TEST(Route, RefusesWhatAPr2CannotDo) {
  const auto made = [](double speed, double rate, std::vector<Eigen::Vector2d> waypoints) {
    return [=] { Route(speed, rate, waypoints); };
  };
  const std::vector<Eigen::Vector2d> way{{0, 0}, {1, 0}};
  using E = std::invalid_argument;
  EXPECT_THAT(made(1.01, 0.5, way), ThrowsMessage<E>(HasSubstr("speed must be in 0.001..1 m/s")));
  EXPECT_THAT(made(0.0, 0.5, way), ThrowsMessage<E>(HasSubstr("speed")));
  EXPECT_THAT(made(NAN, 0.5, way), ThrowsMessage<E>(HasSubstr("speed")));
  EXPECT_THAT(made(0.3, 2.01, way), ThrowsMessage<E>(HasSubstr("turn_rate must be in 0.001..2")));
  EXPECT_THAT(made(0.3, 0.5, {{0, 0}}), ThrowsMessage<E>(HasSubstr("two or more")));
  EXPECT_THAT(made(0.3, 0.5, {{0, 0}, {1, 0}, {1, 0}}),
              ThrowsMessage<E>(HasSubstr("waypoints 2 and 3")));
  EXPECT_THAT(made(0.3, 0.5, {{0, 0}, {INFINITY, 0}}), ThrowsMessage<E>(HasSubstr("finite")));
}

/// What would need gigabytes, or a day, to be driven.
TEST(Route, RefusesWhatNoTourCanMean) {
  const auto made = [](double speed, double rate, std::vector<Eigen::Vector2d> waypoints) {
    return [=] { Route(speed, rate, waypoints); };
  };
  using E = std::invalid_argument;
  const std::vector<Eigen::Vector2d> way{{0, 0}, {20, 0}};
  EXPECT_THAT(made(0.3, 0.5, {{0, 0}, {1e5, 0}}), ThrowsMessage<E>(HasSubstr("10 km")));
  EXPECT_THAT(made(0.3, 0.5, {{0, 0}, {6000, 0}, {0, 0}}), ThrowsMessage<E>(HasSubstr("10 km")));
  EXPECT_THAT(made(0.3, 0.5, {{0, 0}, {1e300, 0}}), ThrowsMessage<E>(HasSubstr("1000 km")));
  EXPECT_THAT(made(1e-9, 0.5, way), ThrowsMessage<E>(HasSubstr("speed must be in 0.001")));
  EXPECT_THAT(made(0.3, 1e-9, way), ThrowsMessage<E>(HasSubstr("turn_rate must be in 0.001")));
  EXPECT_THAT(made(0.001, 0.5, way), ThrowsMessage<E>(HasSubstr("4 hours")));
  std::vector<Eigen::Vector2d> zigzag;
  for (int i = 0; i < 10'001; ++i) zigzag.emplace_back(i % 2, i % 3);
  EXPECT_THAT(made(0.3, 0.5, zigzag), ThrowsMessage<E>(HasSubstr("up to 10000")));
}

/// The body of 0.65 x 0.65 m first touches the wall at x = 2 from x = 1.675.
TEST(Route, ThroughAWallIsRefusedWithThePlaceNamed) {
  const World world = world_of(sdf_block("wall", {2, -3, 0}, {2.1, 3, 2.5}));
  require_free(world, Route(0.3, 0.6, {{0, 0.5}, {1.67, 0.5}}));
  EXPECT_THAT(
      [&] {
        require_free(world, Route(0.3, 0.6, {{0, 0.5}, {4, 0.5}}));
      },
      ThrowsMessage<std::runtime_error>(AllOf(HasSubstr("wall::link::collision"),
                                              HasSubstr("x 1.68, y 0.50"),
                                              HasSubstr("move a waypoint"))));
}

TEST(Route, ATurnOnTheSpotSweepsTheCorners) {
  const World world = world_of(sdf_block("wall", {2, -3, 0}, {2.1, 3, 2.5}));
  const Route turning(0.3, 0.6, {{1.6, 0}, {1.6, 1}, {0, 1}});
  EXPECT_NO_THROW(require_free(world, Route(0.3, 0.6, {{1.6, 0}, {1.6, 1}})));
  EXPECT_THROW(require_free(world, turning), std::runtime_error) << "half a diagonal is 0.46 m";
}

TEST(Route, TheBodyPassesUnderALintelOnlyAsHighAsItIs) {
  const Route route(0.3, 0.6, {{0, 0}, {4, 0}});
  EXPECT_NO_THROW(require_free(world_of(sdf_block("lintel", {2, -1, 1.4}, {2.1, 1, 2})), route));
  EXPECT_THROW(require_free(world_of(sdf_block("shelf", {2, -1, 1.2}, {2.1, 1, 1.25})), route),
               std::runtime_error);
  EXPECT_NO_THROW(require_free(world_of(sdf_block("carpet", {1, -1, 0}, {3, 1, 0.01})), route));
}

/// Returns a cube of +-9 m as a mesh, which is hollow; `bottom` closes it.
World hollow_cube(bool bottom) {
  std::string text;
  for (const char* z : {" -9\n", " 9\n"})
    for (const char* xy : {"v -9 -9", "v 9 -9", "v 9 9", "v -9 9"}) text += std::string(xy) + z;
  text += "f 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  if (bottom) text += "f 4 3 2 1\n";
  const TemporaryDirectory directory;
  write_file(directory.path() / "cube.obj", text);
  write_file(directory.path() / "w.sdf",
             sdf_world(sdf_model("cube", "0 0 0 0 0 0", sdf_mesh("cube.obj"))));
  return World::load((directory.path() / "w.sdf").string());
}

TEST(Route, InsideAClosedMeshIsNotFreeEither) {
  const Route route(0.3, 0.6, {{0, 0}, {1, 0}});
  EXPECT_THROW(require_free(hollow_cube(true), route), std::runtime_error);
  EXPECT_THROW(require_free(hollow_cube(false), Route(0.3, 0.6, {{0, 0}, {9.5, 0}})),
               std::runtime_error)
      << "through its side";
}

/// Solids and closed meshes are detected even if the body is entirely inside them.
TEST(Route, InsideASolidIsNotFree) {
  const World world = world_of(sdf_block("hill", {-9, -9, -9}, {9, 9, 9}));
  EXPECT_THROW(require_free(world, Route(0.3, 0.6, {{0, 0}, {1, 0}})), std::runtime_error);
}

}  // namespace
}  // namespace ribbon_mapper::sim
