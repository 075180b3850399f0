// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/geometry/plane_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <string>

#include "test/modeler/geometry/point_cloud.hpp"

namespace ribbon_mapper {
namespace {

/// Expects the eigenvalues of the iterative solver. Eigenvectors of equal eigenvalues are
/// arbitrary, so the eigenvectors are checked by their defining equation.
void expect_agreement_with_iterative_solver(const std::string& what, const Points& points) {
  SCOPED_TRACE(what);
  const Moments moments = moments_of(points);
  const PlaneFit fit = fit_plane(moments);
  const Eigen::Matrix3d covariance = slow_covariance(points);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> slow(covariance);
  const double largest = std::max(1e-12, slow.eigenvalues()[2]);
  EXPECT_LT((fit.variances - slow.eigenvalues()).norm(), 1e-7 * largest);
  EXPECT_LE(0.0, fit.variances[0]);
  EXPECT_LE(fit.variances[0], fit.variances[1]);
  EXPECT_LE(fit.variances[1], fit.variances[2]);
  EXPECT_LT((fit.axes.transpose() * fit.axes - Eigen::Matrix3d::Identity()).norm(), 1e-9);
  const Eigen::Matrix3d residual =
      covariance * fit.axes - fit.axes * Eigen::Vector3d(slow.eigenvalues()).asDiagonal();
  EXPECT_LT(residual.norm(), 1e-6 * largest);
  EXPECT_NEAR(0.0, fit.normal().dot(fit.mean) + fit.d_m(), 1e-12);
}

TEST(FitPlane, AgreesWithTheIterativeSolver) {
  const Eigen::Vector3d near(1.0, 2.0, 0.5), far(60.0, -40.0, 2.0);
  expect_agreement_with_iterative_solver("a noisy plane", cloud({2.0, 1.0, 0.01}, near, 200, 3));
  expect_agreement_with_iterative_solver("a plane far away", cloud({2.0, 1.0, 0.01}, far, 200, 4));
  expect_agreement_with_iterative_solver("a ribbon", cloud({0.3, 0.015, 0.005}, near, 60, 5));
}

TEST(FitPlane, AgreesWithTheIterativeSolverInDegenerateCases) {
  const Eigen::Vector3d near(1.0, 2.0, 0.5);
  expect_agreement_with_iterative_solver("no thickness", cloud({2.0, 1.0, 0.0}, near, 200, 6));
  expect_agreement_with_iterative_solver("one line", cloud({2.0, 0.0, 0.0}, near, 200, 7));
  expect_agreement_with_iterative_solver("one point", Points(5, near));
  expect_agreement_with_iterative_solver("three points", {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
  expect_agreement_with_iterative_solver("a square",
                                         {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}});
  expect_agreement_with_iterative_solver(
      "a ball", {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
}

TEST(FitPlane, NormalIsAccurateToAMicroradian) {
  for (int seed = 10; seed < 30; ++seed) {
    const Points points = cloud({0.3, 0.02, 0.004}, {5.0, -4.0, 1.0}, 60, seed);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> slow(slow_covariance(points));
    const Eigen::Vector3d normal = fit_plane(moments_of(points)).normal();
    EXPECT_LT(normal.cross(slow.eigenvectors().col(0)).norm(), 1e-6);
  }
}

constexpr Flatness kAnything{1e9, 0.0};

/// Covers the extents of what three scan lines see: from no thickness to far too thick for a
/// normal.
TEST(FlatNormal, AgreesWithTheIterativeSolverForAllExtents) {
  int seed = 100;
  for (const double thickness_m : {0.0, 1e-4, 0.004, 0.012, 0.018}) {
    for (const double base_line_m : {0.02, 0.05, 0.15}) {
      for (const double distance_m : {0.5, 5.0, 60.0}) {
        const Points points = cloud({0.15, base_line_m, thickness_m},
                                    distance_m * Eigen::Vector3d(0.6, -0.7, 0.1), 40, ++seed);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> slow(slow_covariance(points));
        const auto normal = flat_normal(moments_of(points), kAnything);
        ASSERT_TRUE(normal);
        EXPECT_NEAR(1.0, normal->norm(), 1e-12);
        const double off = normal->cross(slow.eigenvectors().col(0)).norm();
        const double variance = normal->dot(slow_covariance(points) * *normal);
        EXPECT_NEAR(slow.eigenvalues()[0], variance, 1e-5 * variance + 1e-10);
        if (slow.eigenvalues()[1] > 2.0 * slow.eigenvalues()[0]) {
          EXPECT_LT(off, 2e-6) << thickness_m << " " << base_line_m << " " << distance_m;
        }
      }
    }
  }
}

TEST(FlatNormal, IsMissingForThickOrNarrowPoints) {
  int flat = 0, count = 0;
  for (int seed = 200; seed < 400; ++seed) {
    const double thickness_m = 0.001 * (seed % 20), width_m = 0.001 * (seed % 37);
    const Points points = cloud({0.3, width_m, thickness_m}, {5.0, -4.0, 1.0}, 60, seed);
    const Eigen::Vector3d variances =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(slow_covariance(points)).eigenvalues();
    const Flatness flatness{1e-4, 2.0};
    const double near = 1e-12 + 1e-4 * variances[1];  // rounding decides within this margin
    if (std::abs(variances[0] - flatness.max_variance_m2) < near ||
        std::abs(variances[1] - 2.0 * variances[0]) < near) {
      continue;
    }
    const bool expected =
        variances[0] < flatness.max_variance_m2 && variances[1] > 2.0 * variances[0];
    EXPECT_EQ(expected, flat_normal(moments_of(points), flatness).has_value()) << "seed " << seed;
    flat += expected, ++count;
  }
  EXPECT_GT(flat, 30);
  EXPECT_GT(count - flat, 30);
}

TEST(FlatNormal, OfDegeneratePointsIsMissingOrOfUnitLength) {
  const Points spot(5, {1, 2, 3}), line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
      ball{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const Points& points : {spot, line, ball}) {
    const auto normal = flat_normal(moments_of(points), kAnything);
    EXPECT_NEAR(1.0, normal.value_or(Eigen::Vector3d::UnitX()).norm(), 1e-9);
  }
  EXPECT_FALSE(flat_normal(moments_of(ball), {1e9, 2.0}));
}

}  // namespace
}  // namespace ribbon_mapper
