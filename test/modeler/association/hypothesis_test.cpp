// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/association/hypothesis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "modeler/geometry/angles.hpp"
#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;
using Vector = Eigen::Vector3d;

const AssociationGates kGates{2.0, 0.05};
const Vector kX = Vector::UnitX(), kY = Vector::UnitY(), kZ = Vector::UnitZ();

/// Returns a wall of 4 x 2 m at x = 2, seen from the origin.
Hypothesis wall() {
  Scene scene;
  scene.add(patch({2.0, 2.0, 0.0}, -4.0 * kY, 2.0 * kZ));
  return scene.whole();
}

/// Returns the membership of a ribbon in the wall, or 0 outside the gates.
double membership_of(const Ribbon& ribbon, const AssociationGates& within = kGates) {
  const auto sigmas = square_sigmas(PosedRibbon(ribbon, Pose::Identity()), wall(), within);
  return sigmas ? membership(*sigmas) : 0.0;
}

/// Returns a ribbon on the wall, moved by `distance_m` along x and rotated about an axis through
/// its middle.
Ribbon ribbon_at_wall(double distance_m, double angle_deg = 0.0, const Vector& axis = kZ,
                      const Vector& middle = {2.0, 0.0, 1.0}) {
  const Pose turn = Eigen::Translation3d(middle + distance_m * kX) *
                    Eigen::AngleAxisd(angle_deg * kDegree, axis) * Eigen::Translation3d(-middle);
  return ribbon_between(turn * Vector(middle + 0.4 * kY), turn * Vector(middle - 0.4 * kY),
                        turn.linear() * -kX);
}

TEST(Hypothesis, IsThePlaneOfItsRibbonsAndFacesTheSensor) {
  const Hypothesis plane = wall();
  EXPECT_LT((plane.normal() + kX).norm(), 1e-9);
  EXPECT_NEAR(2.0, plane.d_m(), 1e-9);
  EXPECT_EQ(51u, plane.members().size());
  EXPECT_NEAR(0.3, plane.signed_distance({1.7, 9.0, 9.0}), 1e-9);
}

TEST(Hypothesis, EqualsOneOfAllRibbonsAfterAbsorbing) {
  Scene left, right, both;
  left.add(patch({2.0, 2.0, 0.0}, -kY, kZ));
  right.add(patch({2.01, 0.0, 0.0}, -kY, kZ));
  both.add(left.ribbons);
  both.add(right.ribbons);
  Hypothesis one = left.whole();
  one.absorb(right.whole());
  EXPECT_LT((both.whole().normal() - one.normal()).norm(), 1e-9);
  EXPECT_NEAR(both.whole().d_m(), one.d_m(), 1e-9);
  EXPECT_NEAR(both.whole().area_m2(), one.area_m2(), 1e-9);
  EXPECT_EQ(both.whole().members().size(), one.members().size());
}

TEST(Hypothesis, WeightsRibbonsByAreaTimesProbability) {
  Scene scene;
  scene.add(patch({2.0, 1.0, 0.0}, -2.0 * kY, kZ));
  scene.add(patch({2.1, 1.0, 0.0}, -2.0 * kY, kZ));
  const std::size_t half = scene.ribbons.size() / 2;
  Hypothesis plane(0);
  for (std::uint32_t i = 0; i < scene.ribbons.size(); ++i) {
    plane.add(scene.observations().ribbon(i), {i, i < half ? 1.0F : 0.25F});
  }
  EXPECT_NEAR(2.0 + 0.2 * 0.1, plane.d_m(), 1e-6);  // weights of eq. 4: 1 and 0.25
}

TEST(Hypothesis, PredictsTheTiltErrorOfFits) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.01);
  double square = 0.0, predicted = 0.0;
  const int runs = 300;
  for (int run = 0; run < runs; ++run) {
    Ribbon ribbon = ribbon_between({2.0, 0.5, 0.0}, {2.0, -0.5, 0.0}, -kX);
    Moments points;
    for (int i = 0; i < 60; ++i) {
      points.add({2.0 + noise(random), -0.5 + i / 59.0, 0.2 * (i % 3)});
    }
    ribbon.moments = points;
    Hypothesis plane(0);
    plane.add(PosedRibbon(ribbon, Pose::Identity()), {0, 1.0F});
    square += std::pow(std::asin(plane.normal().y()), 2) / runs;
    predicted += std::sqrt(plane.tilt_variance(kY)) / runs;
  }
  EXPECT_NEAR(std::sqrt(square), predicted, 0.15 * predicted);
}

TEST(Membership, IsOneOnThePlaneAndFallsWithDistance) {
  EXPECT_NEAR(1.0, membership_of(ribbon_at_wall(0.0)), 1e-9);
  EXPECT_NEAR(std::exp(-0.5), membership_of(ribbon_at_wall(0.025)),
              1e-5);  // one standard deviation
  EXPECT_GT(membership_of(ribbon_at_wall(0.02)), membership_of(ribbon_at_wall(-0.03)));
  EXPECT_GT(membership_of(ribbon_at_wall(0.049)), 0.0);
  EXPECT_EQ(0.0, membership_of(ribbon_at_wall(0.051)));
  EXPECT_EQ(0.0, membership_of(ribbon_at_wall(-0.051)));
}

TEST(Membership, HasGatesForTheAnglesAlongAndAcross) {
  for (const Vector& axis : {kZ, kY}) {
    EXPECT_GT(membership_of(ribbon_at_wall(0.0, 1.9, axis)), 0.0);
    EXPECT_EQ(0.0, membership_of(ribbon_at_wall(0.0, 2.2, axis)));
    EXPECT_GT(membership_of(ribbon_at_wall(0.0, -1.9, axis)), 0.0);
    EXPECT_EQ(0.0, membership_of(ribbon_at_wall(0.0, -2.2, axis)));
  }
}

TEST(Membership, UsesTheDistanceAtTheCentroid) {
  // 12 m away along the wall, rotated by 1.5 degrees: its plane misses the origin's by 30 cm.
  const Ribbon far = ribbon_at_wall(0.0, 1.5, kZ, {2.0, 12.0, 1.0});
  EXPECT_GT(std::abs(far.normal.cast<double>().dot(far.moments.mean()) + 2.0), 0.25);
  EXPECT_GT(membership_of(far), 0.1);
}

TEST(Membership, ToleratesAWeakNormalUpToALimit) {
  Ribbon ribbon = ribbon_at_wall(0.0, 4.0, kY);  // across the ribbon
  EXPECT_EQ(0.0, membership_of(ribbon));
  ribbon.sigma_across_rad = static_cast<float>(2.0 * kDegree);
  EXPECT_GT(membership_of(ribbon), 0.0);
  ribbon = ribbon_at_wall(0.0, 6.0, kY);
  ribbon.sigma_across_rad = static_cast<float>(20.0 * kDegree);
  EXPECT_EQ(0.0, membership_of(ribbon));
}

TEST(Membership, IsZeroOnTheBackOfTheWall) {
  Ribbon back = ribbon_at_wall(0.01);
  back.normal = kX.cast<float>();
  EXPECT_EQ(0.0, membership_of(back, {90.0, 10.0}));
}

/// Returns a patch of 1 x 1 m beside the middle of the wall, moved along x and rotated about its
/// middle.
Hypothesis small_plane(double distance_m, double angle_deg, const Vector& axis) {
  const Pose turn = Eigen::Translation3d(2.0 + distance_m, 3.0, 1.0) *
                    Eigen::AngleAxisd(angle_deg * kDegree, axis);
  Scene scene;
  scene.add(patch({0.0, 0.5, -0.5}, -kY, kZ));
  scene.poses[0].T_map_base = Pose::Identity();
  for (Ribbon& ribbon : scene.ribbons) {
    ribbon.moments = ribbon.moments.transformed(turn);
    ribbon.normal = (turn.linear() * ribbon.normal.cast<double>()).cast<float>();
  }
  return scene.whole();
}

TEST(AreOnePlane, RequiresTheGatesAndTheSameSide) {
  EXPECT_TRUE(are_one_plane(wall(), small_plane(0.0, 0.0, kZ), kGates));
  EXPECT_TRUE(are_one_plane(wall(), small_plane(0.045, 0.0, kZ), kGates));
  EXPECT_FALSE(are_one_plane(wall(), small_plane(0.055, 0.0, kZ), kGates));
  for (const Vector& axis : {kY, kZ}) {
    EXPECT_TRUE(are_one_plane(wall(), small_plane(0.0, 1.9, axis), kGates));
    EXPECT_FALSE(are_one_plane(wall(), small_plane(0.0, 2.2, axis), kGates));
  }
  EXPECT_FALSE(are_one_plane(wall(), small_plane(0.0, 180.0, kZ), {90.0, 10.0}));
}

}  // namespace
}  // namespace ribbon_mapper
