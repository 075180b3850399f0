// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The drift over many seeds against the closed form of gmapping's motion model.
#include "sim/tour/localisation.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace ribbon_mapper::sim {
namespace {

constexpr int kSeeds = 400;  ///< sigma is known to 1 / sqrt(2 * 400) = 3.5 %

/// Root mean squares over the seeds.
struct Spread {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;
};

/// Returns the root mean squares of the error that `error_of` returns for each seed.
Spread spread(const Route& route, const LocalisationConfig& config,
              const std::function<Pose(const Localisation&)>& error_of) {
  Spread sum;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Pose error = error_of(Localisation(route, config, static_cast<std::uint64_t>(seed)));
    sum.x_m += error.translation().x() * error.translation().x();
    sum.y_m += error.translation().y() * error.translation().y();
    sum.yaw_rad += yaw_of(error) * yaw_of(error);
  }
  return {std::sqrt(sum.x_m / kSeeds), std::sqrt(sum.y_m / kSeeds),
          std::sqrt(sum.yaw_rad / kSeeds)};
}

/// Returns the odometry's error at the end of the route, in the frame of the true pose.
Spread end_spread(const Route& route, const LocalisationConfig& config) {
  return spread(route, config, [&](const Localisation& localisation) -> Pose {
    const Pose way = route.T_map_base(Time(0)).inverse() * route.T_map_base(route.duration());
    return way.inverse() * localisation.T_odom_base(route.duration());
  });
}

void expect_within(double value, double expected, double share) {
  EXPECT_NEAR(value / expected, 1.0, share) << value << " against " << expected;
}

/// A drive of 4 m has 8 filter updates of 0.5 m, whose variances add up.
TEST(Localisation, StraightDriveDriftsAsGmappingsModel) {
  const Spread at_end = end_spread(Route(0.5, 0.5, {{0, 0}, {4, 0}}), {});
  const double yaw_rad = 0.02 * 0.5 * std::sqrt(8.0);
  expect_within(at_end.yaw_rad, yaw_rad, 0.15);
  expect_within(at_end.x_m, 0.01 * 0.5 * std::sqrt(8.0), 0.15);
  // Across: a small error of its own, and the random walk of the heading over the way. The latter
  // is L^2 sigma^2 / 3 in the robot's frame at the end.
  const double across_m =
      std::hypot(4.0 * yaw_rad / std::sqrt(3.0), 0.3 * 0.01 * 0.5 * std::sqrt(8.0));
  expect_within(at_end.y_m, across_m, 0.15);
}

TEST(Localisation, TurnsDriftAsGmappingsModel) {
  // Away and back, 1 m each, and two half turns.
  const Spread at_end = end_spread(Route(0.5, 0.5, {{0, 0}, {1, 0}, {0, 0}}), {});
  const double drives = 0.02 * 0.5 * std::sqrt(2.0 / 0.5);
  const double turns = 0.02 * 0.436 * std::sqrt(2.0 * M_PI / 0.436);
  expect_within(at_end.yaw_rad, std::hypot(drives, turns), 0.15);
}

TEST(Localisation, DriftDoesNotDependOnTheStepLength) {
  const Route route(0.5, 0.5, {{0, 0}, {2, 0}, {2, 2}});
  LocalisationConfig coarse;
  coarse.odometry_rate_hz = 10.0;
  const Spread fine = end_spread(route, {}), rough = end_spread(route, coarse);
  const Spread fast = end_spread(Route(1.0, 1.0, {{0, 0}, {2, 0}, {2, 2}}), {});
  for (const Spread& other : {rough, fast}) {
    expect_within(other.x_m, fine.x_m, 0.2);
    expect_within(other.y_m, fine.y_m, 0.2);
    expect_within(other.yaw_rad, fine.yaw_rad, 0.2);
  }
}

TEST(Localisation, ScalesWithDrift) {
  const Route route(0.5, 0.5, {{0, 0}, {4, 0}});
  LocalisationConfig tripled;
  tripled.drift = 3.0;
  const Spread once = end_spread(route, {}), thrice = end_spread(route, tripled);
  expect_within(thrice.yaw_rad, 3.0 * once.yaw_rad, 0.02);  // the same seeds
  expect_within(thrice.x_m, 3.0 * once.x_m, 0.1);
  expect_within(thrice.y_m, 3.0 * once.y_m, 0.05);
}

TEST(Localisation, WithoutDriftIsExact) {
  const Route route(0.4, 0.6, {{1, 2}, {3, 2}, {3, 3}, {1, 2}});
  LocalisationConfig exact;
  exact.drift = 0.0;
  const Localisation localisation(route, exact, 1);
  for (Time t(0); t < route.duration(); t += std::chrono::milliseconds(7)) {
    const Pose believed = localisation.T_map_odom(t) * localisation.T_odom_base(t);
    EXPECT_TRUE(believed.isApprox(route.T_map_base(t), 1e-9)) << to_seconds(t);
  }
  EXPECT_TRUE(localisation.T_odom_base(Time(0)).isApprox(Pose::Identity(), 1e-12))
      << "odom begins where the robot starts";
}

/// SLAM closes no loop: map and odometry differ by the match's place within a cell of 5 cm.
TEST(Localisation, ScanMatchingJittersWithinACell) {
  const Route route(0.5, 0.5, {{0, 0}, {4, 0}});
  const Time at = from_seconds(std::round(to_seconds(route.duration()) / 2.0 * 30.0) / 30.0);
  const Spread matched = spread(route, {}, [&](const Localisation& localisation) -> Pose {
    const Pose T_odom_base = localisation.T_odom_base(at);
    return (route.T_map_base(Time(0)) * T_odom_base).inverse() * localisation.T_map_odom(at) *
           T_odom_base;
  });
  const double sigma_m = std::hypot(0.05 / std::sqrt(12.0), 0.05 / 32.0);
  expect_within(matched.x_m, sigma_m, 0.15);
  expect_within(matched.y_m, sigma_m, 0.15);
  expect_within(matched.yaw_rad, std::hypot(0.05 / std::sqrt(12.0) / 16.0, 0.05 / 32.0), 0.15);
}

TEST(Localisation, OdometryIsSmoothAndTheMapJumpsAtItsOwnRate) {
  const Route route(0.5, 0.5, {{0, 0}, {4, 0}});
  const Localisation localisation(route, {}, 3);
  for (double t = 1.0; t < 5.0; t += 0.001) {
    const Pose step = localisation.T_odom_base(from_seconds(t)).inverse() *
                      localisation.T_odom_base(from_seconds(t + 0.001));
    EXPECT_NEAR(step.translation().x(), 0.0005, 0.0005);
  }
  const Time tick = from_seconds(60.0 / 30.0), next = from_seconds(61.0 / 30.0);
  const Pose a = localisation.T_map_odom(tick), b = localisation.T_map_odom(next);
  EXPECT_GT((b.translation() - a.translation()).norm(), 1e-5);
  EXPECT_TRUE(localisation.T_map_odom((tick + next) / 2).isApprox(interpolate(a, b, 0.5), 1e-6));
}

TEST(Localisation, SameSeedSamePoses) {
  const Route route(0.5, 0.5, {{0, 0}, {2, 0}});
  const Time t = from_seconds(3.1);
  const Localisation a(route, {}, 5), same(route, {}, 5), other(route, {}, 6);
  EXPECT_EQ(a.T_odom_base(t).matrix(), same.T_odom_base(t).matrix());
  EXPECT_EQ(a.T_map_odom(t).matrix(), same.T_map_odom(t).matrix());
  EXPECT_NE(a.T_odom_base(t).matrix(), other.T_odom_base(t).matrix());
}

TEST(Localisation, RefusesImpossibleFigures) {
  const auto refused = [](auto change) {
    LocalisationConfig config;
    change(config);
    EXPECT_THROW(config.validate(), std::invalid_argument);
  };
  refused([](LocalisationConfig& c) { c.drift = -1.0; });
  refused([](LocalisationConfig& c) { c.drift = NAN; });
  refused([](LocalisationConfig& c) { c.srr = -0.01; });
  refused([](LocalisationConfig& c) { c.linear_update_m = 0.0; });
  refused([](LocalisationConfig& c) { c.map_rate_hz = 0.0; });
}

}  // namespace
}  // namespace ribbon_mapper::sim
