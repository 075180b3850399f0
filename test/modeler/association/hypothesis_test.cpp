// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/association/hypothesis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;
using Vector = Eigen::Vector3d;

constexpr double degree = M_PI / 180.0;
const AssociationGates gates{2.0, 0.05};
const Vector x = Vector::UnitX(), y = Vector::UnitY(), z = Vector::UnitZ();

/// A wall of 4 x 2 m at x = 2, seen from the origin.
Hypothesis wall() {
  Scene scene;
  scene.add(patch({2.0, 2.0, 0.0}, -4.0 * y, 2.0 * z));
  return scene.whole();
}

double membership_of(const Ribbon& ribbon, const AssociationGates& within = gates) {
  const auto sigmas = square_sigmas(PosedRibbon(ribbon, Pose::Identity()), wall(), within);
  return sigmas ? membership(*sigmas) : 0.0;
}

/// A ribbon at the wall, moved by `distance_m` along x and turned about an axis by its own middle.
Ribbon ribbon_at_wall(double distance_m, double angle_deg = 0.0, const Vector& axis = z,
                      const Vector& middle = {2.0, 0.0, 1.0}) {
  const Pose turn = Eigen::Translation3d(middle + distance_m * x) *
                    Eigen::AngleAxisd(angle_deg * degree, axis) * Eigen::Translation3d(-middle);
  return ribbon_between(turn * Vector(middle + 0.4 * y), turn * Vector(middle - 0.4 * y),
                        turn.linear() * -x);
}

TEST(Hypothesis, IsThePlaneOfItsRibbonsTowardsTheSensor) {
  const Hypothesis plane = wall();
  EXPECT_LT((plane.normal() + x).norm(), 1e-9);
  EXPECT_NEAR(2.0, plane.d_m(), 1e-9);
  EXPECT_EQ(51u, plane.members().size());
  EXPECT_NEAR(0.3, plane.signed_distance({1.7, 9.0, 9.0}), 1e-9);
}

TEST(Hypothesis, AbsorbsAsIfItHadGotAllItself) {
  Scene left, right, both;
  left.add(patch({2.0, 2.0, 0.0}, -y, z));
  right.add(patch({2.01, 0.0, 0.0}, -y, z));
  both.add(left.ribbons);
  both.add(right.ribbons);
  Hypothesis one = left.whole();
  one.absorb(right.whole());
  EXPECT_LT((both.whole().normal() - one.normal()).norm(), 1e-9);
  EXPECT_NEAR(both.whole().d_m(), one.d_m(), 1e-9);
  EXPECT_NEAR(both.whole().area_m2(), one.area_m2(), 1e-9);
  EXPECT_EQ(both.whole().members().size(), one.members().size());
}

TEST(Hypothesis, RibbonsCountByAreaTimesProbability) {
  Scene scene;
  scene.add(patch({2.0, 1.0, 0.0}, -2.0 * y, z));
  scene.add(patch({2.1, 1.0, 0.0}, -2.0 * y, z));
  const std::size_t half = scene.ribbons.size() / 2;
  Hypothesis plane(0);
  for (std::uint32_t i = 0; i < scene.ribbons.size(); ++i) {
    plane.add(scene.observations().ribbon(i), {i, i < half ? 1.0F : 0.25F});
  }
  EXPECT_NEAR(2.0 + 0.2 * 0.1, plane.d_m(), 1e-6);  // eq. 4: 1 to 0.25
}

TEST(Hypothesis, TiltSigmaIsTheSpreadOfFits) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.01);
  double square = 0.0, predicted = 0.0;
  const int runs = 300;
  for (int run = 0; run < runs; ++run) {
    Ribbon ribbon = ribbon_between({2.0, 0.5, 0.0}, {2.0, -0.5, 0.0}, -x);
    Moments points;
    for (int i = 0; i < 60; ++i) {
      points.add({2.0 + noise(random), -0.5 + i / 59.0, 0.2 * (i % 3)});
    }
    ribbon.moments = points;
    Hypothesis plane(0);
    plane.add(PosedRibbon(ribbon, Pose::Identity()), {0, 1.0F});
    square += std::pow(std::asin(plane.normal().y()), 2) / runs;
    predicted += std::sqrt(plane.tilt_variance(y)) / runs;
  }
  EXPECT_NEAR(std::sqrt(square), predicted, 0.15 * predicted);
}

TEST(Membership, IsCertainOnThePlaneAndFallsWithDistance) {
  EXPECT_NEAR(1.0, membership_of(ribbon_at_wall(0.0)), 1e-9);
  EXPECT_NEAR(std::exp(-0.5), membership_of(ribbon_at_wall(0.025)), 1e-5);  // one sigma
  EXPECT_GT(membership_of(ribbon_at_wall(0.02)), membership_of(ribbon_at_wall(-0.03)));
  EXPECT_GT(membership_of(ribbon_at_wall(0.049)), 0.0);
  EXPECT_EQ(0.0, membership_of(ribbon_at_wall(0.051)));
  EXPECT_EQ(0.0, membership_of(ribbon_at_wall(-0.051)));
}

TEST(Membership, HasAGateForTheAngleAlongAndAcross) {
  for (const Vector& axis : {z, y}) {
    EXPECT_GT(membership_of(ribbon_at_wall(0.0, 1.9, axis)), 0.0);
    EXPECT_EQ(0.0, membership_of(ribbon_at_wall(0.0, 2.2, axis)));
    EXPECT_GT(membership_of(ribbon_at_wall(0.0, -1.9, axis)), 0.0);
    EXPECT_EQ(0.0, membership_of(ribbon_at_wall(0.0, -2.2, axis)));
  }
}

TEST(Membership, DistanceIsTakenAtTheCentroid) {
  // 12 m away along the wall, turned by 1.5 degrees: at the origin it would be off by 30 cm.
  const Ribbon far = ribbon_at_wall(0.0, 1.5, z, {2.0, 12.0, 1.0});
  EXPECT_GT(std::abs(far.normal.cast<double>().dot(far.moments.mean()) + 2.0), 0.25);
  EXPECT_GT(membership_of(far), 0.1);
}

TEST(Membership, AWeakNormalIsExcusedToALimit) {
  Ribbon ribbon = ribbon_at_wall(0.0, 4.0, y);  // across itself
  EXPECT_EQ(0.0, membership_of(ribbon));
  ribbon.sigma_across_rad = static_cast<float>(2.0 * degree);
  EXPECT_GT(membership_of(ribbon), 0.0);
  ribbon = ribbon_at_wall(0.0, 6.0, y);
  ribbon.sigma_across_rad = static_cast<float>(20.0 * degree);
  EXPECT_EQ(0.0, membership_of(ribbon));
}

TEST(Membership, TheBackOfAWallIsAnotherPlane) {
  Ribbon back = ribbon_at_wall(0.01);
  back.normal = x.cast<float>();
  EXPECT_EQ(0.0, membership_of(back, {90.0, 10.0}));
}

Hypothesis small_plane(double distance_m, double angle_deg, const Vector& axis) {
  const Pose turn = Eigen::Translation3d(2.0 + distance_m, 3.0, 1.0) *
                    Eigen::AngleAxisd(angle_deg * degree, axis);
  Scene scene;
  scene.add(patch({0.0, 0.5, -0.5}, -y, z));
  scene.poses[0].T_map_base = Pose::Identity();
  for (Ribbon& ribbon : scene.ribbons) {
    ribbon.moments = ribbon.moments.transformed(turn);
    ribbon.normal = (turn.linear() * ribbon.normal.cast<double>()).cast<float>();
  }
  return scene.whole();
}

TEST(AreOnePlane, WithinTheGatesAndOnOneSide) {
  EXPECT_TRUE(are_one_plane(wall(), small_plane(0.0, 0.0, z), gates));
  EXPECT_TRUE(are_one_plane(wall(), small_plane(0.045, 0.0, z), gates));
  EXPECT_FALSE(are_one_plane(wall(), small_plane(0.055, 0.0, z), gates));
  for (const Vector& axis : {y, z}) {
    EXPECT_TRUE(are_one_plane(wall(), small_plane(0.0, 1.9, axis), gates));
    EXPECT_FALSE(are_one_plane(wall(), small_plane(0.0, 2.2, axis), gates));
  }
  EXPECT_FALSE(are_one_plane(wall(), small_plane(0.0, 180.0, z), {90.0, 10.0}));
}

}  // namespace
}  // namespace ribbon_mapper
