// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/plane_adjustment.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "test/modeler/registration/hall.hpp"

namespace ribbon_mapper {
namespace {

using Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

constexpr double kRobustSigmas = 2.0;

/// Lines of the hall that observe all of its planes, and the segment that they are in.
struct Scene {
  explicit Scene(int lines) {
    for (int i = 0; i < lines; ++i) observations.push_back(hall::observations_of_line(i));
    observing.segment = hall::segment(lines);
    for (int i = 0; i < lines; ++i) {
      observing.lines.push_back({hall::true_pose(i), {}});
      for (std::uint32_t k = 0; k < 3; ++k) {
        observing.lines.back().matches.push_back({&observations[i][k], k});
      }
    }
  }

  /// All poses moved by one error.
  ObservingSegment moved_by(const Vector6& error) const {
    ObservingSegment result = observing;
    for (ObservingLine& line : result.lines) line.T_model_base = moved(line.T_model_base, error);
    return result;
  }

  /// Each pose moved by an error of its own.
  ObservingSegment disturbed(double size) const {
    ObservingSegment result = observing;
    for (std::size_t i = 0; i < result.lines.size(); ++i) {
      Pose& pose = result.lines[i].T_model_base;
      pose = moved(pose, size * hall::random_matrix(6, 1, static_cast<unsigned>(50 + i)));
    }
    return result;
  }

  std::vector<std::vector<PlaneObservation>> observations;
  ObservingSegment observing;
};

std::vector<PlaneLandmark> disturbed_planes(double size) {
  std::vector<PlaneLandmark> planes = hall::planes();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    planes[i] = moved(planes[i], size * hall::random_matrix(3, 1, static_cast<unsigned>(80 + i)));
  }
  return planes;
}

void expect_true_planes(const std::vector<PlaneLandmark>& planes, double tolerance) {
  const std::vector<PlaneLandmark> truth = hall::planes();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    EXPECT_LT((planes[i].normal - truth[i].normal).norm(), tolerance) << i;
    EXPECT_NEAR(0.0, truth[i].normal.dot(planes[i].centroid - truth[i].centroid), tolerance) << i;
  }
}

TEST(PlaneAdjustment, PlanesAndPosesThatErrTogetherComeBackTogether) {
  const Scene scene(20);
  Vector6 error;
  error << 0.02, -0.015, 0.01, 0.004, -0.003, 0.01;
  std::vector<ObservingSegment> segments{scene.moved_by(error)};
  // The planes err as well, by about what these poses make of them.
  std::vector<PlaneLandmark> planes = hall::planes();
  for (PlaneLandmark& plane : planes) plane.centroid += 0.02 * plane.normal;
  for (int i = 0; i < 10; ++i) adjust({}, segments, planes, kRobustSigmas);
  for (int i = 0; i < 20; ++i) {
    const Pose& pose = segments[0].lines[i].T_model_base;
    EXPECT_LT(error_between(hall::true_pose(i), pose).norm(), 1e-4) << "line " << i;
  }
  expect_true_planes(planes, 1e-4);
}

TEST(PlaneAdjustment, KnownLinesHoldThePlanes) {
  const Scene scene(20);
  std::vector<ObservingSegment> none;
  std::vector<PlaneLandmark> planes = hall::planes();
  planes[1] = moved(planes[1], Vector3d(0.02, -0.01, 0.05));
  for (int i = 0; i < 8; ++i) adjust(scene.observing.lines, none, planes, kRobustSigmas);
  expect_true_planes(planes, 1e-3);
}

TEST(PlaneAdjustment, WhatFitsStays) {
  const Scene scene(5);
  std::vector<ObservingSegment> segments{scene.observing};
  std::vector<PlaneLandmark> planes = hall::planes();
  adjust(scene.observing.lines, segments, planes, kRobustSigmas);
  for (int i = 0; i < 5; ++i) {
    EXPECT_LT(hall::difference(hall::true_pose(i), segments[0].lines[i].T_model_base), 1e-5);
  }
  expect_true_planes(planes, 1e-5);
}

TEST(PlaneAdjustment, NothingAtAllIsNoError) {
  std::vector<ObservingSegment> segments;
  std::vector<PlaneLandmark> planes;
  EXPECT_NO_THROW(adjust({}, segments, planes, kRobustSigmas));
  planes = hall::planes();
  adjust({}, segments, planes, kRobustSigmas);
  expect_true_planes(planes, 1e-12);
}

TEST(PlaneAdjustment, WithoutMatchesPosesFollowTheOdometryBetweenTheEnds) {
  Scene scene(6);
  for (ObservingLine& line : scene.observing.lines) line.matches.clear();
  std::vector<ObservingSegment> segments{scene.disturbed(0.01)};
  std::vector<PlaneLandmark> none;
  for (int i = 0; i < 5; ++i) adjust({}, segments, none, kRobustSigmas);
  for (int i = 0; i < 6; ++i) {
    const Pose& pose = segments[0].lines[i].T_model_base;
    EXPECT_LT(error_between(hall::true_pose(i), pose).norm(), 1e-6) << i;
  }
}

TEST(PlaneAdjustment, APlaneThatNobodyMatchedStaysWhereItIs) {
  const Scene scene(5);
  std::vector<ObservingSegment> segments{scene.disturbed(0.001)};
  for (ObservingLine& line : segments[0].lines) line.matches.pop_back();
  std::vector<PlaneLandmark> planes = disturbed_planes(0.001);
  const PlaneLandmark third = planes[2];
  adjust({}, segments, planes, kRobustSigmas);
  EXPECT_LT((third.normal - planes[2].normal).norm(), 1e-12);
  EXPECT_LT((third.centroid - planes[2].centroid).norm(), 1e-12);
  EXPECT_GT((planes[1].centroid - disturbed_planes(0.001)[1].centroid).norm(), 1e-6);
}

TEST(PlaneAdjustment, AFarWrongMatchHasLittleWeight) {
  const Scene scene(10);
  std::vector<ObservingLine> lines = scene.observing.lines;
  lines[4].T_model_base = moved(lines[4].T_model_base, 0.3 * Vector6::Unit(2));  // off the floor
  std::vector<ObservingSegment> none;
  const auto height_with = [&](double robust_sigmas) {
    std::vector<PlaneLandmark> planes = hall::planes();
    adjust(lines, none, planes, robust_sigmas);
    return std::abs(planes[0].centroid.z());
  };
  EXPECT_LT(height_with(2.0), 0.001);
  EXPECT_GT(height_with(1e6), 0.01);
}

/// Unknowns of the dense reference: the errors of all poses, then of all landmarks.
struct DenseReference {
  DenseReference(const std::vector<ObservingLine>& known_, const ObservingSegment& observing_,
                 const std::vector<PlaneLandmark>& landmarks_)
      : known(known_), observing(observing_), landmarks(landmarks_) {
    const auto unknowns = static_cast<int>(6 * observing.lines.size() + 3 * landmarks.size());
    const VectorXd here = residuals(VectorXd::Zero(unknowns));
    const MatrixXd by_errors =
        hall::derivative_by_error([&](const VectorXd& e) { return residuals(e); }, unknowns);
    covariance = (by_errors.transpose() * by_errors).inverse();
    errors = -covariance * by_errors.transpose() * here;
  }

  /// All residuals, whitened by what holds at zero error, with the weak prior on landmarks.
  VectorXd residuals(const VectorXd& e) const {
    std::vector<double> result;
    const auto add = [&](const VectorXd& residual) {
      result.insert(result.end(), residual.data(), residual.data() + residual.size());
    };
    const auto at = static_cast<Eigen::Index>(6 * observing.lines.size());
    add(e.tail(e.size() - at));  // sigma 1
    const auto add_matches = [&](const ObservingLine& line, const Vector6& pose_error) {
      for (const LandmarkMatch& match : line.matches) {
        const PlaneLandmark& before = landmarks[match.landmark];
        const PlaneLandmark after = moved(before, e.segment<3>(at + 3 * match.landmark));
        const Eigen::Vector2d sigmas = match.observation->variances.cwiseSqrt();
        const Eigen::Vector2d here =
            residual_of(*match.observation, before, line.T_model_base).cwiseQuotient(sigmas);
        const Pose pose = moved(line.T_model_base, pose_error);
        const double weight = robust_weight(here.squaredNorm(), kRobustSigmas);
        add(std::sqrt(weight) * residual_of(*match.observation, after, pose).cwiseQuotient(sigmas));
      }
    };
    for (const ObservingLine& line : known) add_matches(line, Vector6::Zero());
    for (std::size_t i = 0; i < observing.lines.size(); ++i) {
      add_matches(observing.lines[i], e.segment<6>(static_cast<Eigen::Index>(6 * i)));
    }
    for (std::size_t i = 0; i < observing.segment.steps.size(); ++i) add_step(i, e, add);
    return VectorXd::Map(result.data(), static_cast<Eigen::Index>(result.size()));
  }

  template <typename Add>
  void add_step(std::size_t i, const VectorXd& e, const Add& add) const {
    const TrajectorySegment& segment = observing.segment;
    const auto pose = [&](std::size_t line, bool is_moved) {
      if (line == 0) return segment.T_frame_start;
      if (line == observing.lines.size() + 1) return segment.T_frame_end;
      const Vector6 error = e.segment<6>(static_cast<Eigen::Index>(6 * (line - 1)));
      const Pose& before = observing.lines[line - 1].T_model_base;
      return std::optional<Pose>(is_moved ? moved(before, error) : before);
    };
    const std::optional<Pose> from = pose(i, true), to = pose(i + 1, true);
    if (!from || !to) return;
    const Vector6 error = error_between(*from * segment.steps[i], *to);
    const Eigen::Matrix3d to_base = pose(i, false)->linear().transpose();
    Vector6 on_axes;
    on_axes << to_base * error.head<3>(), to_base * error.tail<3>();
    Matrix6 information = segment.step_variances[i].cwiseInverse().asDiagonal();
    if (!observing.step_information.empty()) information = observing.step_information[i];
    add(information.llt().matrixU() * on_axes);
  }

  const std::vector<ObservingLine>& known;
  const ObservingSegment& observing;
  const std::vector<PlaneLandmark>& landmarks;
  MatrixXd covariance;
  VectorXd errors;
};

/// One step of adjust() is that of the dense system. Errors are small, so that both are linear.
void expect_dense_solution(const std::vector<ObservingLine>& known,
                           const ObservingSegment& observing) {
  const std::vector<PlaneLandmark> before = disturbed_planes(1e-4);
  const DenseReference reference(known, observing, before);
  std::vector<ObservingSegment> segments{observing};
  std::vector<PlaneLandmark> planes = before;
  const std::vector<Matrix6> covariances = pose_covariances(known, segments, planes, kRobustSigmas);
  ASSERT_EQ(covariances.size(), observing.lines.size());
  for (std::size_t i = 0; i < observing.lines.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(6 * i);
    const Matrix6 expected = reference.covariance.block<6, 6>(at, at);
    EXPECT_LT((covariances[i] - expected).norm(), 2e-3 * expected.norm()) << "line " << i;
  }
  adjust(known, segments, planes, kRobustSigmas);
  const double tolerance = 2e-3 * reference.errors.cwiseAbs().maxCoeff();
  EXPECT_GT(tolerance, 1e-8) << "the reference itself must say something";
  for (std::size_t i = 0; i < observing.lines.size(); ++i) {
    const Vector6 error =
        error_between(observing.lines[i].T_model_base, segments[0].lines[i].T_model_base);
    const Vector6 expected = reference.errors.segment<6>(static_cast<Eigen::Index>(6 * i));
    EXPECT_LT((expected - error).norm(), tolerance) << "line " << i;
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Vector3d expected =
        reference.errors.segment<3>(static_cast<Eigen::Index>(6 * observing.lines.size() + 3 * i));
    const PlaneLandmark solution = moved(before[i], expected);
    EXPECT_LT((solution.normal - planes[i].normal).norm(), tolerance) << "plane " << i;
    EXPECT_LT((solution.centroid - planes[i].centroid).norm(), tolerance) << "plane " << i;
  }
}

TEST(PlaneAdjustment, IsTheDenseSolutionBetweenTwoEnds) {
  const Scene scene(6);
  expect_dense_solution({}, scene.disturbed(1e-4));
}

TEST(PlaneAdjustment, TakesTheInformationOfStepsInPlaceOfTheirVariances) {
  const Scene scene(6);
  ObservingSegment observing = scene.disturbed(1e-4);
  for (const Vector6& variances : observing.segment.step_variances) {
    Matrix6 information = (0.1 * variances).cwiseInverse().asDiagonal();
    information(0, 1) = information(1, 0) = 0.5 * information(0, 0);
    observing.step_information.push_back(information);
  }
  expect_dense_solution({}, observing);
}

TEST(PlaneAdjustment, IsTheDenseSolutionWithAnOpenEnd) {
  const Scene scene(5);
  ObservingSegment observing = scene.disturbed(1e-4);
  observing.segment.T_frame_end.reset();
  expect_dense_solution({}, observing);
}

TEST(PlaneAdjustment, IsTheDenseSolutionWithAnOpenStart) {
  const Scene scene(5);
  ObservingSegment observing = scene.disturbed(1e-4);
  observing.segment.T_frame_start.reset();
  expect_dense_solution({}, observing);
}

TEST(PlaneAdjustment, IsTheDenseSolutionForOneLine) {
  const Scene scene(1);
  expect_dense_solution({}, scene.disturbed(1e-4));
}

TEST(PlaneAdjustment, IsTheDenseSolutionWithKnownLinesAndAPlaneOfOneLineOnly) {
  const Scene scene(6);
  ObservingSegment observing = scene.disturbed(1e-4);
  for (std::size_t i = 0; i < observing.lines.size(); ++i) {
    if (i != 2) observing.lines[i].matches.pop_back();  // the wall ahead
  }
  const std::vector<ObservingLine> known{
      {hall::true_pose(3), {scene.observing.lines[3].matches[1]}}};
  expect_dense_solution(known, observing);
}

}  // namespace
}  // namespace ribbon_mapper
