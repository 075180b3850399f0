// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/odometry_noise.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>
#include <stdexcept>

#include "test/modeler/registration/hall.hpp"

namespace ribbon_mapper {
namespace {

TrajectorySegment segment_of(const std::vector<Pose>& steps, const Pose& T_start_end) {
  TrajectorySegment segment;
  segment.end_line = static_cast<std::uint32_t>(steps.size() - 1);
  segment.steps = steps;
  segment.T_frame_start = hall::any_pose(1);
  segment.T_frame_end = *segment.T_frame_start * T_start_end;
  return segment;
}

/// 60 segments of 40 steps whose odometry errs by `planar` and `spatial` times what the default
/// motion model says.
std::vector<TrajectorySegment> random_walks(double planar, double spatial) {
  OdometryNoise noise;
  noise.planar_scale = planar, noise.spatial_scale = spatial;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<TrajectorySegment> segments;
  for (int i = 0; i < 60; ++i) {
    const std::vector<Pose> steps(40, planar_pose(0.02, 0.0, i % 2 == 0 ? 0.02 : -0.01));
    Pose truth = Pose::Identity();
    for (const Pose& step : steps) {
      const auto noisy = [&](double sigma) { return sigma * normal(random); };
      const Vector6 error = noise.variances(step).cwiseSqrt().unaryExpr(noisy);
      truth = moved(truth * step, error);
    }
    segments.push_back(segment_of(steps, truth));
  }
  return segments;
}

TEST(OdometryNoise, IsThatOfGmappingsMotionModelAtItsReferenceStep) {
  const Vector6 drive = OdometryNoise{}.variances(planar_pose(0.5, 0.0, 0.0));
  EXPECT_NEAR(0.005, std::sqrt(drive[0]), 1e-5);   // srr * 0.5 m
  EXPECT_NEAR(0.0015, std::sqrt(drive[1]), 1e-5);  // 0.3 * srr * 0.5 m
  EXPECT_NEAR(0.01, std::sqrt(drive[5]), 1e-5);    // srt * 0.5 m
  const Vector6 turn = OdometryNoise{}.variances(planar_pose(0.0, 0.0, 0.436));
  EXPECT_NEAR(0.00436, std::sqrt(turn[0]), 1e-5);  // str * 0.436 rad
  EXPECT_NEAR(0.00436, std::sqrt(turn[1]), 1e-5);
  EXPECT_NEAR(0.00872, std::sqrt(turn[5]), 1e-5);  // stt * 0.436 rad
}

TEST(OdometryNoise, OutOfThePlaneItIsAsInThePlaneWithAScaleOfItsOwn) {
  OdometryNoise noise;
  noise.planar_scale = 2.0, noise.spatial_scale = 0.5;
  const Pose step = planar_pose(0.3, 0.1, 0.2);
  const Vector6 variances = noise.variances(step), by_default = OdometryNoise{}.variances(step);
  for (const int i : {0, 1, 5}) EXPECT_NEAR(4.0 * by_default[i], variances[i], 1e-9) << i;
  EXPECT_NEAR(variances[1] / 16.0, variances[2], 1e-9);  // z as y
  EXPECT_NEAR(variances[5] / 16.0, variances[3], 1e-9);  // roll and pitch as yaw
  EXPECT_EQ(variances[3], variances[4]);
}

TEST(OdometryNoise, DoesNotDependOnHowFinelyTheWayIsDivided) {
  const OdometryNoise noise;
  const Vector6 whole = noise.variances(planar_pose(0.4, 0.0, 0.0));
  const Vector6 tenth = noise.variances(planar_pose(0.04, 0.0, 0.0));
  EXPECT_LT((whole - 10.0 * tenth).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_GT(whole[0], 1e-6);
}

TEST(OdometryNoise, StandingStillIsAlmostCertain) {
  const Vector6 variances = OdometryNoise{}.variances(Pose::Identity());
  EXPECT_GT(variances.minCoeff(), 0.0);
  EXPECT_LT(variances.maxCoeff(), 1e-9);
}

TEST(FittedNoise, FindsTheScaleOfRandomWalks) {
  const OdometryNoise found = fitted_noise(random_walks(3.0, 0.2));
  EXPECT_NEAR(3.0, found.planar_scale, 0.5);
  EXPECT_NEAR(0.2, found.spatial_scale, 0.04);
  EXPECT_EQ(OdometryNoise{}.srr, found.srr) << "the shape stays";
}

TEST(FittedNoise, ARobotThatNeverLeavesThePlaneIsExpectedToStayThere) {
  const OdometryNoise found = fitted_noise(random_walks(1.0, 0.0));
  EXPECT_NEAR(1.0, found.planar_scale, 0.2);
  EXPECT_LE(found.spatial_scale, 0.011);
}

TEST(FittedNoise, OfOneStepIsItsErrorInSigmas) {
  const Pose step = planar_pose(0.5, 0.0, 0.0);
  const Vector6 sigmas = OdometryNoise{}.variances(step).cwiseSqrt();
  Vector6 error;
  error << 2.0 * sigmas[0], 0.0, 3.0 * sigmas[2], 0.0, 0.0, -4.0 * sigmas[5];
  const OdometryNoise found = fitted_noise({segment_of({step}, moved(step, error))});
  EXPECT_NEAR(std::sqrt((4.0 + 16.0) / 3.0), found.planar_scale, 1e-6);
  EXPECT_NEAR(std::sqrt(9.0 / 3.0), found.spatial_scale, 1e-6);
}

TEST(FittedNoise, OfAWayWithATurnIsThatOfItsDenseCovariance) {
  const std::vector<Pose> steps(5, planar_pose(0.3, 0.05, 0.3));
  PoseBelief belief;
  for (const Pose& step : steps) belief = after_step(belief, step, OdometryNoise{}.variances(step));
  const Vector6 error = 0.03 * hall::random_matrix(6, 1, 5);
  const std::array<int, 3> in_plane{0, 1, 5};
  Eigen::Matrix3d covariance;
  Eigen::Vector3d e;
  for (int i = 0; i < 3; ++i) {
    e[i] = error[in_plane[i]];
    for (int j = 0; j < 3; ++j) covariance(i, j) = belief.covariance(in_plane[i], in_plane[j]);
  }
  const OdometryNoise found = fitted_noise({segment_of(steps, moved(belief.T_model_base, error))});
  EXPECT_NEAR(std::sqrt(e.dot(covariance.inverse() * e) / 3.0), found.planar_scale, 1e-6);
}

TEST(FittedNoise, APerfectOdometryKeepsAHundredth) {
  const std::vector<Pose> steps(3, planar_pose(0.1, 0.0, 0.05));
  const Pose end = steps[0] * steps[1] * steps[2];
  for (const auto& segment :
       {segment_of(steps, end), segment_of({Pose::Identity()}, Pose::Identity())}) {
    EXPECT_EQ(0.01, fitted_noise({segment}).planar_scale);
    EXPECT_EQ(0.01, fitted_noise({segment}).spatial_scale);
  }
}

TEST(FittedNoise, IgnoresOpenSegmentsAndNeedsAnother) {
  std::vector<TrajectorySegment> segments = random_walks(2.0, 1.0);
  const double without = fitted_noise(segments).planar_scale;
  segments.push_back(segments.front());
  segments.back().T_frame_end.reset();
  EXPECT_EQ(without, fitted_noise(segments).planar_scale);
  EXPECT_THROW(fitted_noise({segments.back()}), std::invalid_argument);
  EXPECT_THROW(fitted_noise({}), std::invalid_argument);
}

TEST(SetStepVariances, SetsThoseOfEachStepAndReplacesOldOnes) {
  TrajectorySegment segment =
      segment_of({planar_pose(0.1, 0.0, 0.0), planar_pose(0.0, 0.0, 0.2)}, Pose::Identity());
  set_step_variances(OdometryNoise{}, segment);
  OdometryNoise noise;
  noise.planar_scale = 3.0;
  set_step_variances(noise, segment);
  ASSERT_EQ(2U, segment.step_variances.size());
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(noise.variances(segment.steps[i]), segment.step_variances[i]);
  }
}

}  // namespace
}  // namespace ribbon_mapper
