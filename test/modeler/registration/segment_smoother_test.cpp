// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/segment_smoother.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

#include "modeler/registration/odometry_noise.hpp"
#include "test/modeler/registration/hall.hpp"

namespace ribbon_mapper {
namespace {

using hall::difference;

constexpr std::size_t kLines = 9;

Pose after(const std::vector<Pose>& steps, std::size_t count) {
  Pose pose = planar_pose(1.0, -2.0, 0.3);
  for (std::size_t i = 0; i < count; ++i) pose = pose * steps[i];
  return pose;
}

TrajectorySegment segment_of(const std::vector<Pose>& steps, const std::optional<Pose>& start,
                             const std::optional<Pose>& end) {
  TrajectorySegment segment;
  segment.end_line = static_cast<std::uint32_t>(steps.size() - 1);
  segment.steps = steps;
  segment.T_frame_start = start, segment.T_frame_end = end;
  set_step_variances(OdometryNoise{}, segment);
  return segment;
}

/// A robot that drives along a curve.
std::vector<Pose> curve() { return std::vector<Pose>(kLines + 1, planar_pose(0.1, 0.0, 0.05)); }

TrajectorySegment closed_curve() {
  return segment_of(curve(), after(curve(), 0), after(curve(), kLines + 1));
}

double yaw_sigma(const PoseBelief& belief) { return std::sqrt(belief.covariance(5, 5)); }

TEST(SegmentSmoother, WithoutMismatchItIsTheOdometry) {
  const SegmentSmoother smoother(closed_curve());
  ASSERT_EQ(kLines, smoother.lines());
  for (std::size_t i = 0; i < kLines; ++i) {
    EXPECT_LT(difference(after(curve(), i + 1), smoother.without(i).T_model_base), 1e-9);
  }
}

TEST(SegmentSmoother, SpreadsAMismatchOverTheWayAndIsLeastCertainInTheMiddle) {
  const std::vector<Pose> steps(kLines + 1, planar_pose(0.0, 0.0, 0.05));  // turns on the spot
  const Pose end = after(steps, kLines + 1) * planar_pose(0.0, 0.0, 0.1);
  const TrajectorySegment segment = segment_of(steps, after(steps, 0), end);
  const SegmentSmoother smoother(segment);
  EXPECT_NEAR(0.3 + 5 * 0.05 + 0.05, yaw_of(smoother.without(4).T_model_base), 1e-6);
  // In the middle of ten equal steps two halves of five meet, each as uncertain as the other.
  const double half = 5 * segment.step_variances[0][5];
  EXPECT_NEAR(std::sqrt(half / 2.0), yaw_sigma(smoother.without(4)), 1e-6);
  EXPECT_GT(yaw_sigma(smoother.without(4)), yaw_sigma(smoother.without(0)));
  EXPECT_GT(yaw_sigma(smoother.without(4)), yaw_sigma(smoother.without(kLines - 1)));
}

TEST(SegmentSmoother, OneEndIsEnough) {
  const std::vector<Pose> steps = curve();
  const SegmentSmoother from_start(segment_of(steps, after(steps, 0), std::nullopt));
  const SegmentSmoother from_end(segment_of(steps, std::nullopt, after(steps, kLines + 1)));
  for (std::size_t i = 0; i < kLines; ++i) {
    EXPECT_LT(difference(after(steps, i + 1), from_start.without(i).T_model_base), 1e-6);
    EXPECT_LT(difference(after(steps, i + 1), from_end.without(i).T_model_base), 1e-6);
  }
  EXPECT_LT(yaw_sigma(from_start.without(0)), yaw_sigma(from_start.without(kLines - 1)));
  EXPECT_GT(yaw_sigma(from_end.without(0)), yaw_sigma(from_end.without(kLines - 1)));
}

TEST(SegmentSmoother, OneLineBetweenEqualStepsIsHalfWay) {
  const std::vector<Pose> steps(2, planar_pose(0.0, 0.0, 0.2));
  const Pose end = after(steps, 2) * planar_pose(0.0, 0.0, 0.1);
  const SegmentSmoother smoother(segment_of(steps, after(steps, 0), end));
  ASSERT_EQ(1U, smoother.lines());
  EXPECT_NEAR(0.3 + 0.2 + 0.05, yaw_of(smoother.without(0).T_model_base), 1e-9);
}

TEST(SegmentSmoother, WithoutALineNothingIsMeasured) {
  SegmentSmoother smoother(segment_of({planar_pose(0.1, 0.0, 0.0)}, Pose::Identity(), {}));
  EXPECT_EQ(0U, smoother.lines());
  smoother.smooth([](std::size_t, const PoseBelief&) -> PoseInformation {
    ADD_FAILURE() << "there is no line";
    return {};
  });
}

TEST(SegmentSmoother, AStandingRobotStaysRegular) {
  const std::vector<Pose> steps(kLines + 1, Pose::Identity());
  const SegmentSmoother smoother(segment_of(steps, after(steps, 0), after(steps, 0)));
  for (std::size_t i = 0; i < kLines; ++i) {
    EXPECT_LT(difference(after(steps, 0), smoother.without(i).T_model_base), 1e-9);
    EXPECT_TRUE(smoother.without(i).covariance.allFinite());
    EXPECT_GT(yaw_sigma(smoother.without(i)), 0.0);
  }
}

TEST(SegmentSmoother, RefusesSegmentsThatItCannotPropagate) {
  TrajectorySegment segment = closed_curve();
  segment.T_frame_start.reset(), segment.T_frame_end.reset();
  EXPECT_THROW(SegmentSmoother{segment}, std::invalid_argument);
  segment = closed_curve();
  segment.step_variances.clear();
  EXPECT_THROW(SegmentSmoother{segment}, std::invalid_argument);
  segment = closed_curve();
  segment.steps.pop_back();
  EXPECT_THROW(SegmentSmoother{segment}, std::invalid_argument);
  EXPECT_THROW(SegmentSmoother{TrajectorySegment{}}, std::invalid_argument);
}

TEST(SegmentSmoother, EachLineIsMeasuredOnceInEachPassWithoutItself) {
  SegmentSmoother smoother(closed_curve());
  std::vector<std::size_t> order;
  smoother.smooth([&](std::size_t line, const PoseBelief& without_it) {
    order.push_back(line);
    EXPECT_EQ(smoother.without(line).T_model_base.matrix(), without_it.T_model_base.matrix());
    PoseInformation measured;
    measured.T_model_base = without_it.T_model_base;
    measured.matrix = 1e6 * Matrix6::Identity();
    return measured;
  });
  EXPECT_EQ((std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 8, 7, 6, 5, 4, 3, 2, 1, 0}),
            order);
}

TEST(SegmentSmoother, WhatOneLineMeasuresItsNeighboursLearn) {
  const std::vector<Pose> steps = curve();
  const Pose truth = after(steps, 5) * planar_pose(0.03, -0.02, 0.04);
  SegmentSmoother smoother(closed_curve());
  const PoseBelief third_before = smoother.without(3), fifth_before = smoother.without(5);
  const auto measure = [&](std::size_t line, const PoseBelief& without_it) {
    PoseInformation measured;
    measured.T_model_base = without_it.T_model_base;
    if (line != 4) return measured;
    measured.matrix = 1e8 * Matrix6::Identity();
    measured.vector = measured.matrix * error_between(without_it.T_model_base, truth);
    return measured;
  };
  smoother.smooth(measure);
  const PoseBelief fourth = updated(smoother.without(4), measure(4, smoother.without(4)));
  EXPECT_LT(difference(truth, fourth.T_model_base), 1e-3);
  const auto off = [&](const PoseBelief& third, const PoseBelief& fifth) {
    return difference(truth, third.T_model_base * steps[4]) +
           difference(truth * steps[5], fifth.T_model_base);
  };
  EXPECT_LT(off(smoother.without(3), smoother.without(5)), 0.5 * off(third_before, fifth_before));
  EXPECT_LT(yaw_sigma(smoother.without(3)), yaw_sigma(third_before));
}

/// Linear measurements of each line's error from the odometry; those of odd lines are of low rank.
struct Measurements {
  explicit Measurements(const TrajectorySegment& segment) {
    for (std::uint32_t i = 0; i < segment.lines(); ++i) {
      nominal.push_back(after(segment.steps, i + 1));
      const Eigen::MatrixXd by_pose = 300.0 * hall::random_matrix(i % 2 == 0 ? 6 : 2, 6, 100 + i);
      matrices.push_back(by_pose.transpose() * by_pose);
      vectors.push_back(matrices.back() * 1e-5 * hall::random_matrix(6, 1, 200 + i));
    }
  }
  PoseInformation operator()(std::size_t line, const PoseBelief&) const {
    return {nominal[line], matrices[line], vectors[line]};
  }
  std::vector<Pose> nominal;
  std::vector<Matrix6> matrices;
  std::vector<Vector6> vectors;
};

/// The belief of all lines' errors by one dense system, leaving out the measurements of one line.
struct DenseReference {
  DenseReference(const TrajectorySegment& segment, const Measurements& measured,
                 std::size_t left_out) {
    const Eigen::Index lines = segment.lines();
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(6 * lines, 6 * lines);
    Eigen::VectorXd vector = Eigen::VectorXd::Zero(6 * lines);
    for (Eigen::Index i = 0; i <= lines; ++i) {
      if (i == 0 && !segment.T_frame_start) continue;
      if (i == lines && !segment.T_frame_end) continue;
      const Pose from = after(segment.steps, i);
      Eigen::MatrixXd by_errors = Eigen::MatrixXd::Zero(6, 6 * lines);
      const Matrix6 carried = transport(from.linear() * segment.steps[i].translation());
      if (i > 0) by_errors.middleCols<6>(6 * (i - 1)) = -carried;
      if (i < lines) by_errors.middleCols<6>(6 * i) = Matrix6::Identity();
      const Matrix6 noise = in_model_axes(segment.step_variances[i], from.linear());
      information += by_errors.transpose() * noise.inverse() * by_errors;
    }
    for (Eigen::Index i = 0; i < lines; ++i) {
      if (static_cast<std::size_t>(i) == left_out) continue;
      information.block<6, 6>(6 * i, 6 * i) += measured.matrices[i];
      vector.segment<6>(6 * i) += measured.vectors[i];
    }
    covariance = information.inverse();
    errors = covariance * vector;
  }
  Eigen::MatrixXd covariance;
  Eigen::VectorXd errors;
};

void expect_dense_solution(const TrajectorySegment& segment) {
  const Measurements measured(segment);
  SegmentSmoother smoother(segment);
  smoother.smooth(measured);
  for (std::size_t i = 0; i < segment.lines(); ++i) {
    const DenseReference reference(segment, measured, i);
    const auto at = static_cast<Eigen::Index>(6 * i);
    const Matrix6 covariance = reference.covariance.block<6, 6>(at, at);
    const Vector6 error = reference.errors.segment<6>(at);
    const PoseBelief belief = smoother.without(i);
    EXPECT_LT((covariance - belief.covariance).norm(), 1e-3 * covariance.norm()) << i;
    const Vector6 found = error_between(measured.nominal[i], belief.T_model_base);
    EXPECT_LT((error - found).norm(), 1e-3 * error.norm() + 1e-9) << i;
    EXPECT_GT(error.norm(), 1e-7) << "the reference itself must say something";
  }
}

TEST(SegmentSmoother, IsTheDenseSolutionBetweenTwoEnds) { expect_dense_solution(closed_curve()); }

TEST(SegmentSmoother, IsTheDenseSolutionWithAnOpenEnd) {
  TrajectorySegment segment = closed_curve();
  segment.T_frame_end.reset();
  expect_dense_solution(segment);
}

TEST(SegmentSmoother, IsTheDenseSolutionWithAnOpenStart) {
  TrajectorySegment segment = closed_curve();
  segment.T_frame_start.reset();
  expect_dense_solution(segment);
}

}  // namespace
}  // namespace ribbon_mapper
