// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/lines/noise_scale.hpp"

#include <gtest/gtest.h>

#include <random>

namespace ribbon_mapper::slam {
namespace {

/// Lines of a robot that drives a circle, with an odometry whose noise is `scale` times gmapping's.
/// Their poses are the true ones.
class Drive {
 public:
  Drive(double scale, int lines) : observations_({}), lines_(observations_) {
    OdometryNoise noise;
    noise.planar_scale = scale;
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    const Pose step = planar_pose(0.01, 0.0, 0.01);
    Pose T_odom_base = Pose::Identity();
    std::vector<Pose> truth{Pose::Identity()};
    for (int i = 0; i < lines; ++i) {
      observations_.add_line({{Time(25'000'000) * i, Pose::Identity()}, T_odom_base}, {});
      const auto noisy = [&](double sigma) { return sigma * normal(random); };
      const Vector6 error = noise.variances(step).cwiseSqrt().unaryExpr(noisy);
      T_odom_base = T_odom_base * moved(step, error);
      truth.push_back(truth.back() * step);
    }
    while (lines_.has_next()) {
      lines_.add_next();
      lines_.set_pose(lines_.size() - 1, truth[lines_.size() - 1]);
    }
  }
  const PosedLines& lines() const { return lines_; }

 private:
  Observations observations_;
  PosedLines lines_;
};

TEST(NoiseScale, IsTheAssumedOneAtFirst) {
  EXPECT_DOUBLE_EQ(NoiseScale(3.0, 1.0).noise().planar_scale, 3.0);
  EXPECT_DOUBLE_EQ(NoiseScale(3.0, 1.0).noise().spatial_scale, 1.0);
}

TEST(NoiseScale, IsLearntWhateverWasAssumed) {
  constexpr int kLines = 40'000;  // 500 spans
  for (const double scale : {0.5, 2.0, 6.0}) {
    const Drive drive(scale, kLines);
    NoiseScale learnt(3.0, 1.0);
    learnt.learn(drive.lines(), 0, kLines);
    // Against true poses, the odometry shows all of its error, of which 0.65 is expected.
    EXPECT_NEAR(learnt.noise().planar_scale / scale, 1.0 / std::sqrt(0.65),
                scale < 1.0 ? 0.35 : 0.12)
        << "scale " << scale;
  }
}

TEST(NoiseScale, OutOfThePlaneIsWhatTheFloorSays) {
  constexpr int kLines = 8000;  // 100 spans
  const Drive drive(1.0, kLines);
  NoiseScale level(3.0, 1.0), rough(3.0, 1.0);
  PosedLines over_bumps = drive.lines();
  for (std::uint32_t i = 0; i < kLines; ++i) {
    const double height_m = 0.05 * std::sin(0.03 * i);
    over_bumps.set_pose(i,
                        Eigen::Translation3d(0.0, 0.0, height_m) * drive.lines().T_start_base(i));
  }
  // The odometry of Drive errs out of the plane as in it.
  level.learn(drive.lines(), 0, kLines);
  rough.learn(over_bumps, 0, kLines);
  EXPECT_LT(level.noise().spatial_scale, 2.0);
  EXPECT_GT(rough.noise().spatial_scale, 3.0);
  EXPECT_LT(rough.noise().planar_scale, 1.2 * level.noise().planar_scale);
}

TEST(NoiseScale, OfARobotThatStandsIsTheAssumedOne) {
  Observations observations({});
  PosedLines lines(observations);
  for (int i = 0; i < 400; ++i) {
    observations.add_line({{Time(25'000'000) * i, Pose::Identity()}, Pose::Identity()}, {});
    lines.add_next();
  }
  NoiseScale learnt(3.0, 1.0);
  learnt.learn(lines, 0, 400);
  EXPECT_DOUBLE_EQ(learnt.noise().planar_scale, 3.0);
}

TEST(NoiseScale, HardlyHeedsASlip) {
  constexpr int kLines = 8000;  // 100 spans
  Drive drive(1.0, kLines);
  NoiseScale without(1.0, 1.0), with(1.0, 1.0);
  without.learn(drive.lines(), 0, kLines);
  PosedLines slipped = drive.lines();
  const Pose slip = planar_pose(0.0, 0.0, 0.5);
  for (std::uint32_t i = kLines / 2; i < kLines; ++i) {
    slipped.set_pose(i, slip * slipped.T_start_base(i));
  }
  with.learn(slipped, 0, kLines);
  EXPECT_LT(with.noise().planar_scale, 1.3 * without.noise().planar_scale);
}

}  // namespace
}  // namespace ribbon_mapper::slam
