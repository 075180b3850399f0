// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/geometry/moments.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>
#include <string>

namespace ribbon_mapper {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// Normally distributed about `centre`, with these standard deviations along turned axes.
Points cloud(const Eigen::Vector3d& sigma, const Eigen::Vector3d& centre, int count, int seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> unit;
  const Eigen::Matrix3d axes =
      Eigen::AngleAxisd(0.9, Eigen::Vector3d(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  Points points;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p(unit(random), unit(random), unit(random));
    points.push_back(centre + axes * sigma.cwiseProduct(p));
  }
  return points;
}

Moments moments_of(const Points& points) {
  Moments moments;
  for (const Eigen::Vector3d& p : points) moments.add(p);
  return moments;
}

Eigen::Vector3d slow_mean(const Points& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) sum += p;
  return sum / points.size();
}

Eigen::Matrix3d slow_covariance(const Points& points) {
  const Eigen::Vector3d mean = slow_mean(points);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) sum += (p - mean) * (p - mean).transpose();
  return sum / points.size();
}

void expect_moments_of(const Points& points, const Moments& moments) {
  EXPECT_NEAR(points.size(), moments.weight(), 1e-9);
  EXPECT_LT((slow_mean(points) - moments.mean()).norm(), 1e-12);
  EXPECT_LT((slow_covariance(points) - moments.covariance()).norm(), 1e-11);
}

const Points first = cloud({0.5, 0.2, 0.01}, {3.0, -2.0, 1.0}, 50, 1);
const Points second = cloud({0.1, 0.9, 0.3}, {-1.0, 4.0, 0.0}, 70, 2);

TEST(Moments, AreThoseOfTheirPoints) { expect_moments_of(first, moments_of(first)); }

TEST(Moments, OfAUnionAreTheSum) {
  Points both = first;
  both.insert(both.end(), second.begin(), second.end());
  expect_moments_of(both, moments_of(first) + moments_of(second));
  expect_moments_of(first, moments_of(both) - moments_of(second));
}

TEST(Moments, OfMovedPointsAreTheMovedMoments) {
  const Pose T = Eigen::Translation3d(7.0, -3.0, 0.5) *
                 Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized());
  Points moved;
  for (const Eigen::Vector3d& p : first) moved.push_back(T * p);
  expect_moments_of(moved, moments_of(first).transformed(T));
  expect_moments_of(first, moments_of(moved).transformed(T.inverse()));
}

TEST(Moments, WeighWithoutMoving) {
  const Moments half = 0.5 * moments_of(first);
  EXPECT_DOUBLE_EQ(25.0, half.weight());
  EXPECT_LT((half.mean() - slow_mean(first)).norm(), 1e-12);
  EXPECT_LT((half.covariance() - slow_covariance(first)).norm(), 1e-12);
}

TEST(Moments, SpreadIsThatOfPairs) {
  const Eigen::Vector3d offset(0.1, -0.2, 0.3);
  Points pairs;
  for (const Eigen::Vector3d& p : first) pairs.push_back(p + offset), pairs.push_back(p - offset);
  Moments spread = moments_of(first);
  spread.spread(offset);
  expect_moments_of(pairs, 2.0 * spread);
}

TEST(Moments, MeanSquareDistanceFromAnyPlane) {
  const Eigen::Vector3d normal = Eigen::Vector3d(1, -2, 2).normalized();
  double sum = 0.0;
  for (const Eigen::Vector3d& p : first) sum += std::pow(normal.dot(p) + 0.7, 2);
  EXPECT_NEAR(sum / first.size(), moments_of(first).mean_square_distance(normal, 0.7), 1e-11);
}

/// Eigenvectors of equal eigenvalues are arbitrary, so what they have to fulfil is checked.
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

TEST(FitPlane, ItsNormalIsGoodToAMicroradian) {
  for (int seed = 10; seed < 30; ++seed) {
    const Points points = cloud({0.3, 0.02, 0.004}, {5.0, -4.0, 1.0}, 60, seed);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> slow(slow_covariance(points));
    const Eigen::Vector3d normal = fit_plane(moments_of(points)).normal();
    EXPECT_LT(normal.cross(slow.eigenvectors().col(0)).norm(), 1e-6);
  }
}

constexpr Flatness anything{1e9, 0.0};

/// Extents of what a laser's three lines see: from far too thick for a normal to none at all.
TEST(FlatNormal, IsTheIterativeSolversOverAllExtents) {
  int seed = 100;
  for (const double thickness_m : {0.0, 1e-4, 0.004, 0.012, 0.018}) {
    for (const double base_line_m : {0.02, 0.05, 0.15}) {
      for (const double distance_m : {0.5, 5.0, 60.0}) {
        const Points points = cloud({0.15, base_line_m, thickness_m},
                                    distance_m * Eigen::Vector3d(0.6, -0.7, 0.1), 40, ++seed);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> slow(slow_covariance(points));
        const auto normal = flat_normal(moments_of(points), anything);
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

TEST(FlatNormal, IsNoneForWhatIsThickOrNarrow) {
  int flat = 0, count = 0;
  for (int seed = 200; seed < 400; ++seed) {
    const double thickness_m = 0.001 * (seed % 20), width_m = 0.001 * (seed % 37);
    const Points points = cloud({0.3, width_m, thickness_m}, {5.0, -4.0, 1.0}, 60, seed);
    const Eigen::Vector3d variances =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(slow_covariance(points)).eigenvalues();
    const Flatness flatness{1e-4, 2.0};
    const double near = 1e-12 + 1e-4 * variances[1];  // no bar is sharper than rounding
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

TEST(FlatNormal, OfWhatHasNoneIsNoneOrOfUnitLength) {
  const Points spot(5, {1, 2, 3}), line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
      ball{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const Points& points : {spot, line, ball}) {
    const auto normal = flat_normal(moments_of(points), anything);
    EXPECT_NEAR(1.0, normal.value_or(Eigen::Vector3d::UnitX()).norm(), 1e-9);
  }
  EXPECT_FALSE(flat_normal(moments_of(ball), {1e9, 2.0}));
}

}  // namespace
}  // namespace ribbon_mapper
