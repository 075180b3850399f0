// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/registration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "test/modeler/registration/hall.hpp"

namespace ribbon_mapper {
namespace {

constexpr int kLines = 61;
const SharedSettings kShared{0.01, {2.0, 0.03}, 1.0};

Time stamp_of(int line) { return from_seconds(1.0 + line); }

/// A drive through the hall whose odometry errs by a random walk of `drift` times 4 mrad and 2 mm
/// a line.
struct Drive {
  explicit Drive(double drift, const Pose& T_map_hall_ = Pose::Identity())
      : T_map_hall(T_map_hall_) {
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    Pose T_odom_base = hall::true_pose(0);
    for (int i = 0; i < kLines; ++i) {
      trajectory.add({{stamp_of(i), T_odom_base}, T_odom_base});
      for (Ribbon ribbon : hall::ribbons_of_line(i)) {
        ribbon.pose = static_cast<std::uint32_t>(i);
        ribbons.push_back(ribbon);
      }
      const double x = 0.002 * normal(random), y = 0.002 * normal(random),
                   yaw = 0.004 * normal(random);
      T_odom_base = T_odom_base * hall::true_pose(i).inverse() * hall::true_pose(i + 1) *
                    planar_pose(drift * x, drift * y, drift * yaw);
    }
  }

  Pose truth(int line) const { return T_map_hall * hall::true_pose(line); }

  void correct_at(const std::vector<int>& lines) {
    std::vector<StampedPose> corrected;
    for (const int line : lines) corrected.push_back({stamp_of(line), truth(line)});
    trajectory.correct(corrected);
  }

  std::vector<StampedPose> registered(const RegistrationConfig& config = {}) const {
    return registered_poses(ribbons, trajectory, config, kShared);
  }

  /// The largest error of lines [first, end): metres and radians.
  double error(const std::vector<StampedPose>& poses, int first, int end) const {
    double largest = 0.0;
    for (int i = first; i < end; ++i) {
      const Pose off = truth(i).inverse() * poses.at(i).T_map_base;
      largest = std::max({largest, off.translation().norm(), angle_of(off)});
    }
    return largest;
  }

  Pose T_map_hall;
  Trajectory trajectory{TrajectoryConfig{}};
  std::vector<Ribbon> ribbons;
};

Drive corrected_drive(const std::vector<int>& lines, double drift = 1.0) {
  Drive drive(drift);
  drive.correct_at(lines);
  return drive;
}

const std::vector<int> kEachTwentieth{0, 20, 40, 60};

TEST(RegisteredPoses, ComeCloserToTheTruth) {
  const Drive drive = corrected_drive(kEachTwentieth);
  const std::vector<StampedPose> poses = drive.registered();
  ASSERT_EQ(kLines, static_cast<int>(poses.size()));
  const double by_odometry = drive.error(drive.trajectory.poses(), 0, kLines);
  EXPECT_GT(by_odometry, 0.01);
  // The motion within a line, which odometry measures as well, bounds what a ribbon tells.
  EXPECT_LT(drive.error(poses, 0, kLines), 0.5 * by_odometry);
}

TEST(RegisteredPoses, LeaveCorrectedOnesAndAllStamps) {
  const Drive drive = corrected_drive(kEachTwentieth);
  const std::vector<StampedPose> poses = drive.registered();
  ASSERT_EQ(kLines, static_cast<int>(poses.size()));
  for (int i = 0; i < kLines; ++i) EXPECT_EQ(stamp_of(i), poses[i].stamp);
  for (const int line : kEachTwentieth) {
    EXPECT_LT(hall::difference(drive.truth(line), poses[line].T_map_base), 1e-12);
  }
}

TEST(RegisteredPoses, MoveWithTheMap) {
  const Drive drive = corrected_drive(kEachTwentieth);
  const Pose shift = Eigen::Translation3d(40.0, -25.0, 3.0) * hall::any_pose(3);
  Drive shifted(1.0, shift);
  shifted.correct_at(kEachTwentieth);
  const std::vector<StampedPose> here = drive.registered(), there = shifted.registered();
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t i = 0; i < here.size(); ++i) {
    EXPECT_LT(hall::difference(shift * here[i].T_map_base, there[i].T_map_base), 1e-6);
  }
}

TEST(RegisteredPoses, AreNoneWithoutACorrection) { EXPECT_TRUE(Drive(1.0).registered().empty()); }

TEST(RegisteredPoses, AreNoneIfSwitchedOff) {
  RegistrationConfig config;
  config.enabled = false;
  EXPECT_TRUE(corrected_drive(kEachTwentieth).registered(config).empty());
}

TEST(RegisteredPoses, AreNoneIfOdometryHasNoError) {
  EXPECT_TRUE(corrected_drive(kEachTwentieth, 0.0).registered().empty());
}

TEST(RegisteredPoses, AreNoneIfThereIsOneCorrectedPose) {
  EXPECT_TRUE(corrected_drive({30}).registered().empty());
}

TEST(RegisteredPoses, AreNoneIfNothingWasSeen) {
  Drive drive = corrected_drive(kEachTwentieth);
  drive.ribbons.clear();
  EXPECT_TRUE(drive.registered().empty());
}

std::vector<int> every(int stride) {
  std::vector<int> lines;
  for (int i = 0; i < kLines; i += stride) lines.push_back(i);
  return lines;
}

TEST(RegisteredPoses, NeedMoreLinesBetweenCorrectedPosesThanARibbonHas) {
  EXPECT_TRUE(corrected_drive(every(1), 5.0).registered().empty());
  EXPECT_TRUE(corrected_drive(every(4), 5.0).registered().empty());
  EXPECT_FALSE(corrected_drive(every(5), 5.0).registered().empty());
}

TEST(RegisteredPoses, ReachBeyondTheFirstAndTheLastCorrectedPose) {
  const Drive drive = corrected_drive({10, 25, 45});
  const std::vector<StampedPose> poses = drive.registered();
  ASSERT_EQ(kLines, static_cast<int>(poses.size()));
  const std::vector<StampedPose> before = drive.trajectory.poses();
  EXPECT_GT(drive.error(before, 0, 10), 0.01);
  EXPECT_LT(drive.error(poses, 0, 10), 0.5 * drive.error(before, 0, 10));
  EXPECT_GT(drive.error(before, 46, kLines), 0.01);
  EXPECT_LT(drive.error(poses, 46, kLines), 0.2 * drive.error(before, 46, kLines));
}

TEST(RegisteredPoses, ReachNoFurtherThanBetweenCorrectedPoses) {
  const Drive drive = corrected_drive({20, 32});
  const std::vector<StampedPose> poses = drive.registered(), before = drive.trajectory.poses();
  ASSERT_EQ(kLines, static_cast<int>(poses.size()));
  double inside = 0.0;
  for (int i = 0; i < kLines; ++i) {
    const double change = hall::difference(before[i].T_map_base, poses[i].T_map_base);
    if (i > 20 && i < 32) inside = std::max(inside, change);
    if (i < 20 || i > 32) {
      EXPECT_LT(change, 1e-12) << i;
    }
  }
  EXPECT_GT(inside, 1e-4);
}

TEST(RegisteredPoses, DependOnEachSetting) {
  const Drive drive = corrected_drive(kEachTwentieth);
  const std::vector<StampedPose> by_default = drive.registered();
  const std::vector<std::function<void(RegistrationConfig&)>> changes{
      [](auto& config) { config.rounds = 1; },
      [](auto& config) { config.passes_per_round = 1; },
      [](auto& config) { config.adjustments_per_round = 0; },
      [](auto& config) { config.min_ribbons = 1000; },
      [](auto& config) { config.shared_sigma_ratio = 0.5; },
      [](auto& config) { config.max_chi_square = 0.1; },
      [](auto& config) { config.robust_sigmas = 0.5; },
      [](auto& config) { config.start_gate_ratio = 0.1; },
      [](auto& config) { config.final_gate_ratio = 0.0; }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    RegistrationConfig config;
    changes[i](config);
    const std::vector<StampedPose> poses = drive.registered(config);
    ASSERT_EQ(by_default.size(), poses.size()) << i;
    double change = 0.0;
    for (std::size_t k = 0; k < poses.size(); ++k) {
      change = std::max(change, hall::difference(by_default[k].T_map_base, poses[k].T_map_base));
    }
    EXPECT_GT(change, 0.0) << "setting " << i;
  }
}

TEST(RegisteredPoses, AreTheSameForTheSame) {
  const Drive drive = corrected_drive(kEachTwentieth);
  const std::vector<StampedPose> first = drive.registered(), second = drive.registered();
  for (int i = 0; i < kLines; ++i) {
    EXPECT_EQ(first.at(i).T_map_base.matrix(), second.at(i).T_map_base.matrix());
  }
}

}  // namespace
}  // namespace ribbon_mapper
