// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Frames whose origin is far away, as that of UTM: the model is the same.
#include <gtest/gtest.h>

#include <limits>

#include "modeler/modeler.hpp"
#include "test/modeler/plane_matchers.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;

Lines tour() { return drive(room(), {around_the_middle, to_and_fro, wandering_drift}, 0.0, 7.0); }

/// Moves the origin of odom.
void move_odom(const Pose& T_new_old, Lines& lines, std::size_t from = 0) {
  for (std::size_t i = from; i < lines.size(); ++i) {
    LinePoses& poses = lines[i].poses;
    poses.T_odom_base_first = T_new_old * poses.T_odom_base_first;
    poses.T_odom_base_last = T_new_old * poses.T_odom_base_last;
  }
}

/// Expects the planes of another model, moved by a translation, to `tolerance`: rad, m, and a share
/// of the area for 20 times as much.
void expect_moved(const std::vector<Plane>& before, const std::vector<Plane>& after,
                  const Eigen::Vector3d& shift, double tolerance = 1e-4) {
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_LT((before[i].normal - after[i].normal).norm(), tolerance) << "plane " << i;
    const double distance_m = before[i].normal.dot(after[i].origin - shift) + before[i].d_m;
    EXPECT_LT(std::abs(distance_m), tolerance) << "plane " << i;
    EXPECT_NEAR(before[i].area_m2, after[i].area_m2, 20.0 * tolerance * before[i].area_m2)
        << "plane " << i;
  }
}

/// Returns the planes of the lines, corrected by every 20th true pose after `T_new_map`.
std::vector<Plane> corrected_planes(const Lines& lines, const Pose& T_new_map) {
  Modeler modeler = model_of(lines);
  std::vector<StampedPose> truth = true_trajectory(lines, 20);
  for (StampedPose& pose : truth) pose.T_map_base = T_new_map * pose.T_map_base;
  modeler.correct(truth);
  return modeler.planes();
}

class FarOdometry : public ::testing::TestWithParam<Eigen::Vector3d> {};

TEST_P(FarOdometry, MakesTheSamePlanes) {
  Lines lines = tour();
  const std::vector<Plane> near = corrected_planes(lines, Pose::Identity());
  expect_one_for_each(room(), near, 0.3, 0.02);
  move_odom(Pose(Eigen::Translation3d(GetParam())) * planar_pose(0.0, 0.0, 0.7), lines);
  expect_moved(near, corrected_planes(lines, Pose::Identity()), Eigen::Vector3d::Zero());
}

INSTANTIATE_TEST_SUITE_P(Places, FarOdometry,
                         ::testing::Values(Eigen::Vector3d(499, -499, 0),
                                           Eigen::Vector3d(5e5, 5.3e6, 500),
                                           Eigen::Vector3d(3e6, 5e6, 0)));

class FarMap : public ::testing::TestWithParam<Eigen::Vector3d> {};

TEST_P(FarMap, MovesThePlanesAndNothingElse) {
  Lines lines = tour();
  const std::vector<Plane> near = corrected_planes(lines, Pose::Identity());
  const Pose T_new_map(Eigen::Translation3d{GetParam()});
  for (Line& line : lines) line.poses.T_map_base = T_new_map * line.poses.T_map_base;
  expect_moved(near, corrected_planes(lines, T_new_map), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Places, FarMap,
                         ::testing::Values(Eigen::Vector3d(5e5, 5.3e6, 500),
                                           Eigen::Vector3d(-6.4e6, 0, 6.4e6)));

/// A receiver of satellites often starts after the odometry. Only pairs of lines over the jump are
/// lost; the trajectory's odometry is that of the messages.
TEST(Far, AJumpOfOdometryCostsAFewLines) {
  Lines lines = tour();
  const std::vector<Plane> near = model_of(lines).planes_as_built();
  move_odom(Pose(Eigen::Translation3d(5e5, 5.3e6, 0)), lines, lines.size() / 2);
  Modeler modeler = model_of(lines);
  expect_moved(near, modeler.planes_as_built(), Eigen::Vector3d::Zero(), 0.002);
  EXPECT_LT(model_of(tour()).trajectory().size(), modeler.trajectory().size() + 30);
}

/// The plane map is relative to the first pose: what comes after the jump has little precision
/// until a correction, but costs neither memory nor time.
TEST(Far, AJumpOfTheMapIsCorrectedLater) {
  Lines lines = tour();
  const Pose T_utm_map(Eigen::Translation3d(5e5, 5.3e6, 0));
  for (std::size_t i = 20; i < lines.size(); ++i) {
    lines[i].poses.T_map_base = T_utm_map * lines[i].poses.T_map_base;
  }
  Modeler modeler = model_of(lines);
  modeler.planes();
  std::vector<StampedPose> truth = true_trajectory(lines);
  for (StampedPose& pose : truth) pose.T_map_base = T_utm_map * pose.T_map_base;
  modeler.correct(truth);
  std::vector<Plane> planes = modeler.planes();
  EXPECT_EQ(planes.size(), 6U);
}

TEST(Far, PosesThatCannotBeAreMalformed) {
  const Lines lines = tour();
  Modeler modeler{ModelerConfig{}};
  for (const Line& line : lines) {
    for (const double absurd_m : {1e10, -1e19, 1e300}) {
      Line bad = line;
      bad.poses.T_map_base.translation().x() = absurd_m;
      EXPECT_EQ(LineResult::malformed, modeler.add_scan_line(bad.beams, bad.poses));
      bad = line;
      bad.poses.T_odom_base_first.translation().y() = absurd_m;
      bad.poses.T_odom_base_last.translation().y() = absurd_m;
      EXPECT_EQ(LineResult::malformed, modeler.add_scan_line(bad.beams, bad.poses));
    }
    modeler.add_scan_line(line.beams, line.poses);
  }
  EXPECT_EQ(bytes_of(model_of(lines).planes()), bytes_of(modeler.planes()));
}

}  // namespace
}  // namespace ribbon_mapper
