// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The whole modeler with corrected poses that are far apart: lines between them are registered.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "modeler/modeler.hpp"
#include "test/modeler/plane_matchers.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;

constexpr double kDuration_s = 15.0;

/// A random walk of 2 degrees and 2 cm in a second. `spatial` scales it for height, roll and pitch.
PoseByTime random_walk(unsigned seed, double spatial) {
  constexpr double kStep_s = 0.01;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, std::sqrt(kStep_s));
  std::vector<Pose> drifts{Pose::Identity()};
  for (int i = 0; i <= kDuration_s / kStep_s + 2; ++i) {
    Eigen::Vector3d slip_m, turn_rad;
    for (int axis = 0; axis < 3; ++axis) slip_m[axis] = 0.02 * normal(random);
    for (int axis = 0; axis < 3; ++axis) turn_rad[axis] = 0.035 * normal(random);
    slip_m.z() *= spatial, turn_rad.head<2>() *= spatial;
    const Pose error =
        Eigen::Translation3d(slip_m) * Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized());
    // Errors are made where the robot is.
    const Pose there = around_the_middle(i * kStep_s);
    drifts.push_back(drifts.back() * there * error * there.inverse(Eigen::Isometry));
  }
  return [drifts](double time_s) {
    const double at = time_s / kStep_s;
    const auto before = static_cast<std::size_t>(at);
    return interpolate(drifts[before], drifts[before + 1], at - before);
  };
}

Lines drifting_tour(unsigned seed = 5, double spatial = 0.0) {
  return drive(room(), {around_the_middle, to_and_fro, random_walk(seed, spatial)}, 0.0,
               kDuration_s);
}

constexpr std::size_t kEachTwoSeconds = 80;  // lines

double largest_yaw_error_deg(const Modeler& modeler) {
  double largest = 0.0;
  for (const StampedPose& pose : modeler.trajectory()) {
    const Pose truth = around_the_middle(to_seconds(pose.stamp) - 1000.0);
    const double error = std::abs(yaw_of(truth.inverse(Eigen::Isometry) * pose.T_map_base));
    largest = std::max(largest, error * 180.0 / M_PI);
  }
  return largest;
}

void expect_model_of_dense_poses(const Lines& lines) {
  Modeler sparse = model_of(lines), dense = model_of(lines);
  sparse.correct(true_trajectory(lines, kEachTwoSeconds));
  dense.correct(true_trajectory(lines));
  EXPECT_LT(largest_yaw_error_deg(sparse), 1.0);
  const auto a = anonymous(sparse.planes()), b = anonymous(dense.planes());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_GT(a[i].normal.dot(b[i].normal), std::cos(0.2 * M_PI / 180.0));
    EXPECT_NEAR(0.0, a[i].normal.dot(b[i].centroid) + a[i].d_m, 0.005);
  }
}

TEST(SparseCorrection, GivesTheModelOfADenseOne) {
  for (const unsigned seed : {5U, 6U, 7U}) {
    SCOPED_TRACE(seed);
    expect_model_of_dense_poses(drifting_tour(seed));
  }
}

TEST(SparseCorrection, AlsoWhereTheOdometryLeavesThePlane) {
  for (const unsigned seed : {5U, 6U}) {
    SCOPED_TRACE(seed);
    expect_model_of_dense_poses(drifting_tour(seed, 0.5));
  }
}

TEST(SparseCorrection, LeavesCorrectedPosesWhereTheyAre) {
  const Lines lines = drifting_tour();
  Modeler modeler = model_of(lines);
  const std::vector<StampedPose> corrected = true_trajectory(lines, kEachTwoSeconds);
  modeler.correct(corrected);
  std::size_t met = 0;
  for (const StampedPose& pose : modeler.trajectory()) {
    for (const StampedPose& exact : corrected) {
      if (exact.stamp != pose.stamp) continue;
      EXPECT_LT((exact.T_map_base.matrix() - pose.T_map_base.matrix()).norm(), 1e-12);
      ++met;
    }
  }
  EXPECT_GE(met, 5U);
}

TEST(SparseCorrection, TwiceTheSameChangesNothing) {
  const Lines lines = drifting_tour();
  Modeler modeler = model_of(lines);
  modeler.correct(true_trajectory(lines, kEachTwoSeconds));
  const std::string planes = bytes_of(modeler.planes_as_built()),
                    merged = bytes_of(modeler.planes());
  modeler.correct(true_trajectory(lines, kEachTwoSeconds));
  EXPECT_EQ(planes, bytes_of(modeler.planes_as_built()));
  EXPECT_EQ(merged, bytes_of(modeler.planes()));
}

TEST(SparseCorrection, AShiftMovesEveryPlaneByThat) {
  const Pose shift = Eigen::Translation3d(40.0, -25.0, 3.0) *
                     Eigen::AngleAxisd(2.5, Eigen::Vector3d(0.2, -0.3, 0.9).normalized());
  const Lines lines = drifting_tour();
  Modeler modeler = model_of(lines);
  std::vector<StampedPose> corrected = true_trajectory(lines, kEachTwoSeconds);
  modeler.correct(corrected);
  std::vector<Plane> expected = modeler.planes();
  for (Plane& plane : expected) plane = moved(plane, shift);
  for (StampedPose& pose : corrected) pose.T_map_base = shift * pose.T_map_base;
  modeler.correct(corrected);
  expect_same(expected, modeler.planes(), 1e-6);
}

TEST(SparseCorrection, AnOdometryWithoutErrorsIsBelieved) {
  const Lines lines = drive(room(), {around_the_middle, to_and_fro, no_drift}, 0.0, kDuration_s);
  Modeler modeler = model_of(lines);
  const std::vector<StampedPose> recorded = modeler.trajectory();
  modeler.correct(true_trajectory(lines, kEachTwoSeconds));
  double largest = 0.0;
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    const Pose pose = modeler.trajectory()[i].T_map_base;
    largest = std::max(largest, (recorded[i].T_map_base.matrix() - pose.matrix()).norm());
  }
  EXPECT_LT(largest, 1e-4);  // registration would move lines by millimetres
}

TEST(SparseCorrection, SwitchedOffLinesFollowTheOdometry) {
  const Lines lines = drifting_tour();
  ModelerConfig config;
  config.registration.enabled = false;
  Modeler by_odometry = model_of(lines, config), registered = model_of(lines);
  by_odometry.correct(true_trajectory(lines, kEachTwoSeconds));
  registered.correct(true_trajectory(lines, kEachTwoSeconds));
  EXPECT_GT(largest_yaw_error_deg(by_odometry), 2.0 * largest_yaw_error_deg(registered));
}

TEST(SparseCorrection, WithNothingToSeeTheOdometryHolds) {
  World world;  // the floor alone, which determines neither position nor heading
  world.push_back(room()[4]);
  const Lines lines =
      drive(world, {around_the_middle, to_and_fro, random_walk(5, 0.0)}, 0.0, kDuration_s);
  Modeler modeler = model_of(lines);
  modeler.correct(true_trajectory(lines, kEachTwoSeconds));
  EXPECT_LT(largest_yaw_error_deg(modeler), 15.0);
  EXPECT_EQ(1U, modeler.planes().size());
}

}  // namespace
}  // namespace ribbon_mapper
