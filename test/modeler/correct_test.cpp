// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Holds the central property: the model is a function of ribbons and trajectory.
#include <gtest/gtest.h>

#include <algorithm>

#include "modeler/modeler.hpp"
#include "test/modeler/plane_matchers.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;

/// Returns lines of the room, recorded with drift.
Lines drifting_tour() {
  return drive(room(), {around_the_middle, to_and_fro, wandering_drift}, 0.0, 15.0);
}

/// Returns a configuration with the same gates before and after a correction, so that only the
/// trajectory makes a difference.
ModelerConfig equal_gates() {
  ModelerConfig config;
  config.association.slam = config.association.corrected;
  return config;
}

std::vector<StampedPose> moved(std::vector<StampedPose> trajectory, const Pose& T) {
  for (StampedPose& pose : trajectory) pose.T_map_base = T * pose.T_map_base;
  return trajectory;
}

std::vector<Plane> moved(std::vector<Plane> planes, const Pose& T) {
  for (Plane& plane : planes) plane = mini_world::moved(plane, T);
  return planes;
}

const Pose kFarAndTilted = Eigen::Translation3d(40.0, -25.0, 3.0) *
                           Eigen::AngleAxisd(2.5, Eigen::Vector3d(0.2, -0.3, 0.9).normalized());

TEST(Correct, EqualsACleanBuildWithTheCorrectedTrajectory) {
  const Lines lines = drifting_tour();
  Modeler corrected = model_of(lines, equal_gates());
  const std::vector<Plane> noisy = corrected.planes();
  corrected.correct(true_trajectory(lines));
  const Modeler clean = model_of(with_true_acquisition_poses(lines), equal_gates());
  EXPECT_GT(noisy.size(), 6u);  // there were errors to correct
  expect_one_for_each(room(), corrected.planes(), 0.3, 0.01);
  expect_same(anonymous(clean.planes_as_built()), anonymous(corrected.planes_as_built()), 1e-6);
  expect_same(anonymous(clean.planes()), anonymous(corrected.planes()), 1e-6);
}

TEST(Correct, MovesTheTrajectoryToTheCorrectedPoses) {
  const Lines lines = drifting_tour();
  Modeler modeler = model_of(lines);
  const std::vector<StampedPose> truth = true_trajectory(lines);
  modeler.correct(truth);
  ASSERT_GT(modeler.trajectory().size(), 500u);
  Time last{0};
  for (const StampedPose& pose : modeler.trajectory()) {
    const auto same = std::find_if(truth.begin(), truth.end(),
                                   [&](const StampedPose& p) { return p.stamp == pose.stamp; });
    ASSERT_NE(truth.end(), same);
    EXPECT_LT((same->T_map_base.matrix() - pose.T_map_base.matrix()).norm(), 1e-9);
    EXPECT_GT(pose.stamp, last);
    last = pose.stamp;
  }
}

TEST(Correct, IsIdempotent) {
  const Lines lines = drifting_tour();
  Modeler modeler = model_of(lines);
  modeler.correct(true_trajectory(lines));
  const std::string planes = bytes_of(modeler.planes_as_built()),
                    merged = bytes_of(modeler.planes());
  for (int i = 0; i < 2; ++i) {
    modeler.correct(true_trajectory(lines));
    EXPECT_EQ(planes, bytes_of(modeler.planes_as_built()));
    EXPECT_EQ(merged, bytes_of(modeler.planes()));
  }
  EXPECT_EQ(3u, modeler.statistics().revision);
}

TEST(Correct, ReplacesTheFormerCorrection) {
  const Lines lines = drifting_tour();
  Modeler modeler = model_of(lines);
  modeler.correct(true_trajectory(lines));
  const std::vector<Plane> first = modeler.planes();
  modeler.correct(moved(true_trajectory(lines, 100), kFarAndTilted));
  modeler.correct(true_trajectory(lines));
  expect_same(anonymous(first), anonymous(modeler.planes()), 1e-12);
}

TEST(Correct, MovesAllPlanesWithTheTrajectory) {
  const Lines lines = drifting_tour();
  Modeler modeler = model_of(lines);
  modeler.correct(true_trajectory(lines));
  const std::vector<Plane> planes = modeler.planes_as_built(), merged = modeler.planes();
  ASSERT_EQ(6u, merged.size());
  modeler.correct(moved(true_trajectory(lines), kFarAndTilted));
  const double relative = 1e-9 * kFarAndTilted.translation().norm();
  expect_same(moved(planes, kFarAndTilted), modeler.planes_as_built(), relative);
  expect_same(moved(merged, kFarAndTilted), modeler.planes(), relative);
}

TEST(Correct, NeedsOnlyOnePoseForARigidMotion) {
  const Lines lines = drifting_tour();
  Modeler one = model_of(lines), all = model_of(lines);
  std::vector<StampedPose> shifted = moved(one.trajectory(), kFarAndTilted);
  all.correct(shifted);
  one.correct({shifted[300]});
  expect_same(all.planes(), one.planes(), 1e-9);
}

TEST(Correct, GivesTheSameModelForSparseKeyframes) {
  const Lines lines = drifting_tour();
  Modeler sparse = model_of(lines), dense = model_of(lines);
  sparse.correct(true_trajectory(lines, 40));  // one per second
  dense.correct(true_trajectory(lines));
  expect_one_for_each(room(), sparse.planes(), 0.3, 0.01);
  const auto a = anonymous(sparse.planes()), b = anonymous(dense.planes());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_GT(a[i].normal.dot(b[i].normal), std::cos(0.2 * M_PI / 180.0));
    EXPECT_NEAR(0.0, a[i].normal.dot(b[i].centroid) + a[i].d_m, 0.005);
  }
}

TEST(Correct, KeepsIds) {
  const Lines lines = drifting_tour();
  Modeler modeler = model_of(lines);
  const std::vector<Plane> before = modeler.planes();
  modeler.correct(true_trajectory(lines));
  const std::vector<Plane> after = modeler.planes();
  EXPECT_EQ(6u, after.size());
  for (const Plane& plane : after) {
    const auto same = std::find_if(before.begin(), before.end(),
                                   [&](const Plane& p) { return p.id == plane.id; });
    ASSERT_NE(before.end(), same) << "id " << plane.id << " is new";
    EXPECT_GT(same->normal.dot(plane.normal), 0.95);
  }
}

/// Returns lines of two walls seen one after the other. The localisation is off by `error_m` along
/// x while the second one is seen.
Lines walls_seen_apart(double first_x_m, double second_x_m, double error_m) {
  const auto world = [](double x_m, double sign) {
    const double y_m = 1.2 * sign;
    return World{plane(-Eigen::Vector3d::UnitX(), x_m, Eigen::Vector3d(0, y_m - 1.2, 0),
                       Eigen::Vector3d(9, y_m + 1.2, 2.5))};
  };
  Motion motion = tilting_in_place();
  Lines lines = drive(world(first_x_m, -1.0), motion, 0.0, 6.0);
  motion.drift = [=](double) { return planar_pose(error_m, 0.0, 0.0); };
  const Lines second = drive(world(second_x_m, 1.0), motion, 6.0, 12.0);
  lines.insert(lines.end(), second.begin(), second.end());
  return lines;
}

TEST(Correct, SplitsPlanesThatWereWronglyMerged) {
  const Lines lines = walls_seen_apart(3.0, 3.2, -0.2);
  for (const ModelerConfig& config : {equal_gates(), ModelerConfig{}}) {
    Modeler modeler = model_of(lines, config);
    const auto recorded = modeler.trajectory();
    EXPECT_EQ(1u, modeler.planes_as_built().size());
    EXPECT_EQ(1u, modeler.planes().size());
    modeler.correct(true_trajectory(lines));
    expect_one_for_each(
        {plane(-Eigen::Vector3d::UnitX(), 3.0), plane(-Eigen::Vector3d::UnitX(), 3.2)},
        modeler.planes(), 0.5, 0.01);
    EXPECT_EQ(2u, modeler.planes_as_built().size());
    modeler.correct(recorded);
    EXPECT_EQ(1u, modeler.planes().size());
  }
}

TEST(Correct, UnitesDuplicates) {
  const Lines lines = walls_seen_apart(3.0, 3.0, 0.3);
  Modeler modeler = model_of(lines);
  EXPECT_EQ(2u, modeler.planes().size());
  modeler.correct(true_trajectory(lines));
  expect_one_for_each({plane(-Eigen::Vector3d::UnitX(), 3.0)}, modeler.planes(), 0.5, 0.01);
}

TEST(Correct, AppliesTheLastChangeToLaterLines) {
  const Lines lines = drifting_tour();
  const Lines first(lines.begin(), lines.begin() + 300);
  ModelerConfig config;
  config.trajectory.poses_follow = false;  // tf goes on drifting
  Modeler modeler = model_of(first, config), at_once = model_of(lines, config);
  std::vector<StampedPose> truth = true_trajectory(first);
  truth.pop_back();  // the last line enters the model with the next one
  modeler.correct(truth);
  at_once.correct(truth);
  for (std::size_t i = 300; i < lines.size(); ++i) {
    modeler.add_scan_line(lines[i].beams, lines[i].poses);
  }
  ASSERT_EQ(at_once.trajectory().size(), modeler.trajectory().size());
  for (std::size_t i = 0; i < modeler.trajectory().size(); ++i) {
    const Pose expected = at_once.trajectory()[i].T_map_base;
    EXPECT_LT((expected.matrix() - modeler.trajectory()[i].T_map_base.matrix()).norm(), 1e-9);
  }
  expect_same(anonymous(at_once.planes()), anonymous(modeler.planes()), 1e-6);
}

TEST(Correct, TrustsThePosesOfLaterLinesIfTfFollows) {
  const Lines lines = drifting_tour();
  const Lines first(lines.begin(), lines.begin() + 300);
  const Lines corrected = with_true_acquisition_poses(lines);
  Modeler modeler = model_of(first);
  modeler.correct(true_trajectory(first));
  for (std::size_t i = 300; i < lines.size(); ++i) {
    modeler.add_scan_line(corrected[i].beams, corrected[i].poses);
  }
  expect_one_for_each(room(), modeler.planes(), 0.3, 0.01);
}

}  // namespace
}  // namespace ribbon_mapper
