// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/geometry/pose.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "modeler/geometry/pose_defect.hpp"

namespace ribbon_mapper {
namespace {

Pose random_pose(std::mt19937& random) {
  std::uniform_real_distribution<double> in(-1.0, 1.0);
  const Eigen::Quaterniond rotation =
      Eigen::Quaterniond(in(random), in(random), in(random), in(random)).normalized();
  return Eigen::Translation3d(10.0 * in(random), 10.0 * in(random), in(random)) * rotation;
}

double distance(const Pose& a, const Pose& b) { return (a.matrix() - b.matrix()).norm(); }

TEST(Time, IsExactToTheNanosecond) {
  EXPECT_EQ(Time(25'000'000), from_seconds(0.025));
  EXPECT_EQ(Time(-1), from_seconds(-1e-9));
  EXPECT_EQ(Time(2'000'000'001), from_seconds(2.000000001));
  EXPECT_DOUBLE_EQ(12.345678901, to_seconds(Time(12'345'678'901)));
}

TEST(Interpolate, ReturnsThePosesAtTheEnds) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const Pose a = random_pose(random), b = random_pose(random);
    EXPECT_LT(distance(interpolate(a, b, 0.0), a), 1e-12);
    EXPECT_LT(distance(interpolate(a, b, 1.0), b), 1e-12);
    EXPECT_LT(distance(interpolate(a, b, 0.3), interpolate(b, a, 0.7)), 1e-12);
  }
}

TEST(Interpolate, RotatesTheShorterWayAtConstantSpeed) {
  const Pose a = planar_pose(0.0, 0.0, 3.0), b = planar_pose(1.0, 2.0, -3.0);
  const double turn = 2.0 * M_PI - 6.0;
  for (const double fraction : {0.1, 0.5, 0.8}) {
    const Pose pose = interpolate(a, b, fraction);
    EXPECT_LT(distance(pose, planar_pose(fraction, 2.0 * fraction, 3.0 + fraction * turn)), 1e-12);
  }
}

TEST(Interpolate, DoesNotDependOnTheFrame) {
  std::mt19937 random(2);
  for (int i = 0; i < 20; ++i) {
    const Pose a = random_pose(random), b = random_pose(random), T = random_pose(random);
    EXPECT_LT(distance(T * interpolate(a, b, 0.4), interpolate(T * a, T * b, 0.4)), 1e-11);
  }
}

TEST(PlanarPose, TransformsPointsFromBaseToMap) {
  const Pose T_map_base = planar_pose(1.0, 2.0, M_PI_2);
  EXPECT_LT((T_map_base * Eigen::Vector3d(3.0, 0.0, 0.5) - Eigen::Vector3d(1.0, 5.0, 0.5)).norm(),
            1e-12);
  EXPECT_DOUBLE_EQ(-2.5, yaw_of(planar_pose(4.0, 5.0, -2.5)));
}

TEST(AngleOf, IsIndependentOfTheAxis) {
  for (const Eigen::Vector3d& axis :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0.6, 0, -0.8), Eigen::Vector3d(0, 0, -1)}) {
    EXPECT_NEAR(0.7, angle_of(Pose(Eigen::AngleAxisd(0.7, axis))), 1e-12);
    EXPECT_NEAR(0.7, angle_of(Pose(Eigen::AngleAxisd(-0.7, axis))), 1e-12);
  }
}

TEST(IsValid, AcceptsOnlyFiniteRigidTransforms) {
  std::mt19937 random(3);
  EXPECT_TRUE(is_valid(random_pose(random)));
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Pose pose = Pose::Identity();
    pose.translation().y() = bad;
    EXPECT_FALSE(is_valid(pose));
    pose = Pose::Identity();
    pose.linear()(2, 1) = bad;
    EXPECT_FALSE(is_valid(pose));
  }
  Pose scaled = Pose::Identity();
  scaled.linear() *= 1.001;
  EXPECT_FALSE(is_valid(scaled));
  Pose zero = Pose::Identity();
  zero.linear().setZero();
  EXPECT_FALSE(is_valid(zero));
  Pose mirror = Pose::Identity();
  mirror.linear()(0, 0) = -1.0;
  EXPECT_FALSE(is_valid(mirror));
}

TEST(FindDefect, NamesWhatIsWrongWithAPose) {
  EXPECT_EQ(std::nullopt, find_defect(planar_pose(1e9, -1e9, 1.0)));
  EXPECT_EQ("lies more than 1e9 m from the origin", find_defect(planar_pose(0.0, -1.1e9, 1.0)));
  EXPECT_EQ("lies more than 1e9 m from the origin", find_defect(planar_pose(1e19, 0.0, 1.0)));
  EXPECT_EQ("is not finite",
            find_defect(planar_pose(std::numeric_limits<double>::infinity(), 0.0, 1.0)));
  Pose flat = Pose::Identity();
  flat.linear().setZero();
  EXPECT_EQ("is not rigid", find_defect(flat));
}

}  // namespace
}  // namespace ribbon_mapper
