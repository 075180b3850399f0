// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/base_laser/level_odometry.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>

#include "test/slam/matching/wall_world.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr double kPeriod_s = 0.1;            // from scan to scan
constexpr double kSeen = 0.01, kOpen = 0.3;  // standard deviations of a step [m, rad]

Time stamp_of(double scan) { return from_seconds(10.0 + kPeriod_s * scan); }

Pose in_space(const PlanarPose& pose) { return planar_pose(pose.x_m, pose.y_m, pose.yaw_rad); }

/// A robot that scans at each of its poses, and by what of its odometry it is posed.
struct Drive {
  WallWorld world;
  std::vector<PlanarPose> truth, odometry;
  std::function<bool(std::size_t scan)> has_scan = [](std::size_t) { return true; };
  double noise_m = 0.0;  // of ranges

  void feed(LevelOdometry& odometry_of_both) const {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (!has_scan(i)) continue;
      LaserBeams beams = world.beams(truth[i]);
      for (float& range : beams.ranges_m) range += static_cast<float>(noise_m * normal(random));
      beams.stamp = stamp_of(static_cast<double>(i));
      const Pose T_odom_base = in_space(odometry[i]);
      odometry_of_both.add_scan(beams, {T_odom_base, T_odom_base});
    }
  }
  /// Returns the refined pose half way between a scan and the next.
  PlanarPose refined_behind(const LevelOdometry& refined, std::size_t scan) const {
    const Pose pose = refined.T_odom_base(stamp_of(static_cast<double>(scan) + 0.5),
                                          in_space(halfway(odometry, scan)));
    return {pose.translation().x(), pose.translation().y(), yaw_of(pose)};
  }
  /// Returns the standard deviations of the way from half way before a scan to half way behind it,
  /// by the scans.
  Eigen::Vector3d sigmas_at(const LevelOdometry& refined, std::size_t scan) const {
    const PlanarPose step =
        relative(refined_behind(refined, scan - 1), refined_behind(refined, scan));
    return refined
        .step_covariance(stamp_of(static_cast<double>(scan) - 0.5),
                         stamp_of(static_cast<double>(scan) + 0.5), in_space(step))
        .diagonal()
        .cwiseSqrt();
  }
  /// Returns the error of the way from one scan to another.
  double error_m(const LevelOdometry& refined, std::size_t from, std::size_t to) const {
    return distance_m(relative(halfway(truth, from), halfway(truth, to)),
                      relative(refined_behind(refined, from), refined_behind(refined, to)));
  }
  double error_of_odometry_m(std::size_t from, std::size_t to) const {
    return distance_m(relative(halfway(truth, from), halfway(truth, to)),
                      relative(halfway(odometry, from), halfway(odometry, to)));
  }
  static PlanarPose halfway(const std::vector<PlanarPose>& poses, std::size_t scan) {
    const PlanarPose step = relative(poses[scan], poses[scan + 1]);
    return poses[scan] * planar(0.5 * step.vector());
  }
};

Drive around_a_ring() {
  const std::vector<PlanarPose> truth = ring_drive(0.4, 0.1);
  return {WallWorld::ring(), truth, drifting(truth, 0.04, 0.01)};
}

Drive along(const WallWorld& world) {
  std::vector<PlanarPose> truth;
  for (int i = 0; i < 150; ++i) truth.push_back({0.1 * i, 0.0, 0.0});
  return {world, truth, drifting(truth, 0.04, 0.01)};
}

LevelOdometry refined_by(const Drive& drive) {
  LevelOdometry refined{LevelOdometryConfig()};
  drive.feed(refined);
  return refined;
}

TEST(LevelOdometry, FollowsTheTruthBetweenScans) {
  const Drive drive = around_a_ring();
  const LevelOdometry refined = refined_by(drive);
  const std::size_t last = drive.truth.size() - 2;
  ASSERT_GT(drive.error_of_odometry_m(0, last), 1.0);
  for (std::size_t scan = 0; scan <= last; ++scan) EXPECT_LT(drive.error_m(refined, 0, scan), 0.08);
  EXPECT_EQ(refined.matched(), drive.truth.size());
  for (std::size_t scan = 1; scan <= last; ++scan)
    EXPECT_LT(drive.sigmas_at(refined, scan).maxCoeff(), kSeen);
}

TEST(LevelOdometry, SameInputGivesTheSamePoses) {
  const Drive drive = around_a_ring();
  const LevelOdometry a = refined_by(drive), b = refined_by(drive);
  for (std::size_t scan = 0; scan + 1 < drive.truth.size(); ++scan) {
    EXPECT_EQ(drive.refined_behind(a, scan).vector(), drive.refined_behind(b, scan).vector());
  }
}

TEST(LevelOdometry, HeightRollAndPitchAreTheRecordedOnes) {
  const Drive drive = around_a_ring();
  const LevelOdometry refined = refined_by(drive);
  const Eigen::Affine3d tilt(Eigen::Translation3d(0.0, 0.0, 0.2) *
                             Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitY()) *
                             Eigen::AngleAxisd(-0.03, Eigen::Vector3d::UnitX()));
  const Pose recorded = in_space(drive.odometry[70]) * Pose(tilt.matrix());
  const Pose pose = refined.T_odom_base(stamp_of(70.0), recorded);
  EXPECT_GT((pose.translation() - recorded.translation()).head<2>().norm(), 0.05);
  EXPECT_NEAR(pose.translation().z(), 0.2, 1e-12);
  EXPECT_TRUE(pose.linear().row(2).isApprox(recorded.linear().row(2), 1e-12));
}

TEST(LevelOdometry, WithoutScansIsTheRecordedOne) {
  const LevelOdometry refined{LevelOdometryConfig()};
  const Pose recorded = planar_pose(1.0, 2.0, 0.3);
  EXPECT_EQ(refined.T_odom_base(stamp_of(0.0), recorded).matrix(), recorded.matrix());
  EXPECT_EQ(refined.matched(), 0U);
}

TEST(LevelOdometry, IsTheRecordedOneBeforeTheFirstScan) {
  Drive drive = around_a_ring();
  drive.has_scan = [](std::size_t scan) { return scan >= 60; };
  const LevelOdometry refined = refined_by(drive);
  EXPECT_LT(distance_m(drive.refined_behind(refined, 59), Drive::halfway(drive.odometry, 59)),
            1e-12);
  EXPECT_LT(distance_m(drive.refined_behind(refined, 60), Drive::halfway(drive.odometry, 60)),
            0.02);
  EXPECT_LT(drive.error_m(refined, 60, drive.truth.size() - 2), 0.08);
  EXPECT_GT(drive.sigmas_at(refined, 60).minCoeff(), kOpen);
  EXPECT_LT(drive.sigmas_at(refined, 61).maxCoeff(), kSeen);
}

TEST(LevelOdometry, MovesAsTheRecordedOneAfterTheLastScan) {
  Drive drive = around_a_ring();
  drive.has_scan = [](std::size_t scan) { return scan <= 100; };
  const LevelOdometry refined = refined_by(drive);
  EXPECT_LT(drive.error_m(refined, 0, 100), 0.08);
  const PlanarPose step =
      relative(drive.refined_behind(refined, 100), drive.refined_behind(refined, 150));
  const PlanarPose recorded =
      relative(Drive::halfway(drive.odometry, 100), Drive::halfway(drive.odometry, 150));
  EXPECT_LT((step.vector() - recorded.vector()).norm(), 1e-9);
  EXPECT_LT(drive.sigmas_at(refined, 100).maxCoeff(), kSeen);
  EXPECT_GT(drive.sigmas_at(refined, 102).minCoeff(), kOpen);
}

TEST(LevelOdometry, GoesOnAfterScansThatAreMissing) {
  Drive drive = around_a_ring();
  drive.has_scan = [](std::size_t scan) { return scan < 60 || scan > 80; };  // 2 m of way
  const LevelOdometry refined = refined_by(drive);
  EXPECT_LT(drive.error_m(refined, 0, drive.truth.size() - 2), 0.08);
  EXPECT_LT(drive.error_m(refined, 0, 70), 0.08);
  EXPECT_GT(drive.sigmas_at(refined, 70).minCoeff(), kOpen);
  EXPECT_GT(drive.sigmas_at(refined, 81).minCoeff(), kOpen) << "what was missed is put right here";
  EXPECT_LT(drive.sigmas_at(refined, 82).maxCoeff(), kSeen);
}

TEST(LevelOdometry, StaysTheRecordedOneInTheOpen) {
  const Drive drive = along(WallWorld({}));
  const LevelOdometry refined = refined_by(drive);
  const std::size_t last = drive.truth.size() - 2;
  EXPECT_LT(
      (drive.refined_behind(refined, last).vector() - Drive::halfway(drive.odometry, last).vector())
          .norm(),
      1e-9);
  EXPECT_GT(drive.sigmas_at(refined, last).minCoeff(), kOpen);
}

TEST(LevelOdometry, AlongABareCorridorTheRecordedWayStays) {
  Drive drive = along(WallWorld::corridor());
  drive.noise_m = 0.01;  // feigns that the way is seen, and drags
  const LevelOdometry refined = refined_by(drive);
  const std::size_t last = drive.truth.size() - 2;
  const PlanarPose way =
      relative(drive.refined_behind(refined, 0), drive.refined_behind(refined, last));
  const double recorded_m = 0.1 * static_cast<double>(last) * 1.04;
  EXPECT_NEAR(way.x_m, recorded_m, 1e-4 * recorded_m);
  EXPECT_NEAR(way.y_m, 0.0, 0.1);
  EXPECT_NEAR(way.yaw_rad, 0.0, 0.02);
  for (std::size_t scan = 1; scan <= last; ++scan) {
    const Eigen::Vector3d sigmas = drive.sigmas_at(refined, scan);
    EXPECT_GT(sigmas.x(), kOpen);
    EXPECT_LT(sigmas.y(), kSeen);
    EXPECT_LT(sigmas.z(), kSeen);
  }
}

TEST(LevelOdometry, ShowsThatARobotWasPushed) {
  Drive drive{WallWorld::room(), {}, std::vector<PlanarPose>(40)};
  for (int i = 0; i < 40; ++i)
    drive.truth.push_back(i < 20 ? PlanarPose{} : PlanarPose{0.2, 0.1, 0.1});
  const LevelOdometry refined = refined_by(drive);
  EXPECT_LT(drive.error_m(refined, 0, 38), 0.02);
  EXPECT_LT(drive.sigmas_at(refined, 18).maxCoeff(), kSeen);
  EXPECT_LT(refined.matched(), 10U);  // the other scans of a robot that stands are not needed
}

TEST(LevelOdometry, RefusesWhatItCannotUseAndGoesOn) {
  const WallWorld world = WallWorld::room();
  LevelOdometry refined{LevelOdometryConfig()};
  LaserBeams beams = world.beams({});
  beams.stamp = stamp_of(1.0);
  const Pose here = Pose::Identity();
  Pose broken = here;
  broken.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(refined.add_scan(beams, {broken, here}), std::invalid_argument);
  const Pose tilted(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()));
  EXPECT_THROW(refined.add_scan(beams, {here, here, tilted, tilted}), std::invalid_argument);
  EXPECT_EQ(refined.matched(), 0U);
  refined.add_scan(beams, {here, here});
  EXPECT_THROW(refined.add_scan(beams, {here, here}), std::invalid_argument);
  EXPECT_EQ(refined.matched(), 1U);
}

}  // namespace
}  // namespace ribbon_mapper::slam
