// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/plane_observation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "test/modeler/association/scene.hpp"
#include "test/modeler/registration/hall.hpp"

namespace ribbon_mapper {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

constexpr RangeNoise kNoise{0.01, 0.25};

/// A ribbon of `length_m` along y on a wall 2 m ahead of the base and 1 m up.
Ribbon wall_ribbon(double length_m = 1.0) {
  return mini_world::ribbon_between({2.0, -0.5 * length_m, 1.0}, {2.0, 0.5 * length_m, 1.0},
                                    -Vector3d::UnitX());
}

PlaneObservation observed(const Ribbon& ribbon, const RangeNoise& noise = kNoise) {
  return {ribbon, noise, Vector6::Zero()};
}

const PlaneLandmark kWall{
    -Vector3d::UnitX(), Vector3d::UnitY(), -Vector3d::UnitZ(), {2.0, 0.3, 0.8}};

TEST(PlaneObservation, TakesTheRibbonsGeometry) {
  Ribbon ribbon = wall_ribbon();
  ribbon.sigma_across_rad = 0.125F;
  const PlaneObservation wall = observed(ribbon);
  EXPECT_LT((wall.centroid - Vector3d(2.0, 0.0, 1.0)).norm(), 1e-6);
  EXPECT_LT((wall.normal + Vector3d::UnitX()).norm(), 1e-6);
  EXPECT_LT((wall.along - Vector3d::UnitY()).norm(), 1e-6);
  EXPECT_LT((wall.across - wall.normal.cross(wall.along)).norm(), 1e-12);
  EXPECT_NEAR(0.125, wall.sigma_across_rad, 1e-12);
  EXPECT_TRUE(wall.candidates.empty());
}

TEST(PlaneObservation, MorePointsAverageTheNoiseButForTheSharedPart) {
  const Ribbon ribbon = wall_ribbon();  // 101 points, a weight of two each line beside
  const double weight = ribbon.moments.weight();
  EXPECT_NEAR(1e-4 / weight, observed(ribbon, {0.01, 0.0}).variances[0], 1e-9);
  EXPECT_NEAR(1e-4 / weight + square(0.0025), observed(ribbon).variances[0], 1e-9);
  const Ribbon twice_as_long = wall_ribbon(2.0);
  const double ratio = observed(ribbon, {0.01, 0.0}).variances[0] /
                       observed(twice_as_long, {0.01, 0.0}).variances[0];
  EXPECT_NEAR(201.0 / 101.0, ratio, 1e-4);
}

TEST(PlaneObservation, ItsTiltIsThatOfALineThroughItsPoints) {
  const PlaneObservation wall = observed(wall_ribbon(2.0));
  const double length_m = wall_ribbon(2.0).length_m;
  EXPECT_NEAR(2.0, length_m, 0.03);
  EXPECT_NEAR(12.0 * wall.variances[0] / square(length_m), wall.variances[1], 1e-12);
}

TEST(PlaneObservation, MotionWithinTheLineAddsWhatItDoesToTheRibbon) {
  Vector6 motion;  // of a beam in the mean: a quarter of the way from line to line
  motion << 1e-4, 2e-4, 3e-4, 4e-5, 5e-5, 6e-5;
  const PlaneObservation still = observed(wall_ribbon());
  const PlaneObservation moving(wall_ribbon(), kNoise, 4.0 * motion);
  const auto derivative = derivative_by_pose(still, still.normal, Pose::Identity());
  const Vector2d expected = derivative.cwiseAbs2() * motion;
  EXPECT_LT((still.variances + expected - moving.variances).norm(), 1e-12);
  // The wall ahead: x, pitch about the height of 1 m, and yaw about no lever; its tilt: yaw.
  EXPECT_NEAR(1e-4 + 5e-5, expected[0], 1e-9);
  EXPECT_NEAR(6e-5, expected[1], 1e-9);
}

/// Returns the slope of the plane through three parallel lines, 3 cm apart, of which the outer ones
/// are displaced along the normal.
double slope(double before_m, double after_m) {
  constexpr double kLineStep_m = 0.03;
  Moments lines;
  for (const double along_m : {-0.5, 0.5}) {
    lines.add({along_m, -kLineStep_m, before_m});
    lines.add({along_m, 0.0, 0.0});
    lines.add({along_m, kLineStep_m, after_m});
  }
  const Vector3d normal = fit_plane(lines).normal();
  return -normal.y() / normal.z();
}

TEST(PlaneObservation, MotionFromLineToLineTipsTheRibbon) {
  // Both outer lines move by a standard deviation of 2 mm: each alone tips the plane.
  const double sigma_m = 0.002;
  const double expected_rad = std::hypot(slope(sigma_m, 0.0), slope(0.0, sigma_m));
  Ribbon ribbon = wall_ribbon();
  Moments line;
  for (int i = -50; i <= 50; ++i) line.add({2.0, 0.01 * i, 1.0});
  line.spread(std::sqrt(2.0 / 3.0) * 0.03 * Vector3d::UnitZ());  // the base line of three lines
  ribbon.moments = line;
  Vector6 step = Vector6::Zero();
  step[0] = square(sigma_m);  // towards the wall
  EXPECT_NEAR(expected_rad, PlaneObservation(ribbon, kNoise, step).sigma_across_rad, 1e-4);
  ribbon.sigma_across_rad = 0.03F;
  EXPECT_NEAR(std::hypot(expected_rad, 0.03),
              PlaneObservation(ribbon, kNoise, step).sigma_across_rad, 1e-4);
}

TEST(RangeNoise, TheSharedPartIsARatio) { EXPECT_DOUBLE_EQ(0.0025, kNoise.shared_sigma_m()); }

TEST(Residual, IsDistanceAndTilt) {
  const PlaneObservation wall = observed(wall_ribbon());
  EXPECT_LT(residual_of(wall, kWall, Pose::Identity()).norm(), 1e-6);
  // 0.1 m towards the wall: the ribbon lies behind it, as seen along the normal.
  const Vector2d near = residual_of(wall, kWall, planar_pose(0.1, 0.0, 0.0));
  EXPECT_NEAR(-0.1, near[0], 1e-6);
  EXPECT_NEAR(0.0, near[1], 1e-6);
  const Vector2d turned = residual_of(wall, kWall, planar_pose(0.0, 0.0, 0.1));
  EXPECT_NEAR(2.0 - 2.0 * std::cos(0.1), turned[0], 1e-6);
  EXPECT_NEAR(std::sin(0.1), turned[1], 1e-6);
  EXPECT_LT(residual_of(wall, kWall, planar_pose(0.0, 5.0, 0.0)).norm(), 1e-6)
      << "along the wall nothing changes";
}

TEST(Residual, DerivativeByPoseIsThatOfFiniteDifferences) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Pose pose = hall::any_pose(seed);
    for (const PlaneLandmark& plane : hall::planes()) {
      const PlaneObservation observation = hall::observations_of_line(5)[seed % 3];
      const auto residual = [&](const Vector6& error) -> Eigen::VectorXd {
        return residual_of(observation, plane, moved(pose, error));
      };
      const Eigen::MatrixXd expected = hall::derivative_by_error(residual, 6);
      EXPECT_LT((expected - derivative_by_pose(observation, plane.normal, pose)).norm(), 1e-8);
    }
  }
}

TEST(Residual, DerivativeByLandmarkIsThatOfFiniteDifferences) {
  const Pose pose = hall::any_pose(4);
  for (const unsigned seed : {1U, 2U, 3U}) {
    const PlaneLandmark plane = moved(hall::planes()[seed % 3], Vector3d(0.3, -0.2, 0.5));
    const PlaneObservation observation = hall::observations_of_line(7)[seed % 3];
    const auto residual = [&](const Vector3d& error) -> Eigen::VectorXd {
      return residual_of(observation, moved(plane, error), pose);
    };
    const Eigen::MatrixXd expected = hall::derivative_by_error(residual, 3);
    EXPECT_LT((expected - derivative_by_landmark(observation, plane, pose)).norm(), 1e-8);
  }
}

TEST(PlaneLandmark, IsMovedByTipsAndAnOffset) {
  const PlaneLandmark offset = moved(kWall, {0.0, 0.0, 0.2});
  EXPECT_LT((offset.centroid - kWall.centroid - 0.2 * kWall.normal).norm(), 1e-12);
  EXPECT_LT((offset.normal - kWall.normal).norm(), 1e-12);
  const PlaneLandmark tipped = moved(kWall, {1e-4, 2e-4, 0.0});
  EXPECT_LT((tipped.centroid - kWall.centroid).norm(), 1e-12);
  EXPECT_NEAR(1e-4, tipped.normal.dot(kWall.axis_u), 1e-9);
  EXPECT_NEAR(2e-4, tipped.normal.dot(kWall.axis_v), 1e-9);
}

TEST(PlaneLandmark, KeepsARightHandedFrameOfUnitAxes) {
  PlaneLandmark plane = kWall;
  for (int i = 0; i < 100; ++i) plane = moved(plane, {0.1, -0.07, 0.01});
  Eigen::Matrix3d axes;
  axes << plane.axis_u, plane.axis_v, plane.normal;
  EXPECT_LT((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_NEAR(1.0, axes.determinant(), 1e-12);
  EXPECT_LT((moved(plane, Vector3d::Zero()).axis_u - plane.axis_u).norm(), 1e-12);
}

TEST(RobustWeight, IsOneAtZeroHalfAtItsSigmasAndFallsOn) {
  EXPECT_EQ(1.0, robust_weight(0.0, 2.0));
  EXPECT_EQ(0.5, robust_weight(square(2.0), 2.0));
  EXPECT_EQ(0.5, robust_weight(square(3.0), 3.0));
  EXPECT_NEAR(1.0 / 26.0, robust_weight(square(10.0), 2.0), 1e-12);
}

}  // namespace
}  // namespace ribbon_mapper
