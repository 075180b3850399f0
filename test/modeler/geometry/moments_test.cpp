// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/geometry/moments.hpp"

#include <gtest/gtest.h>

#include "test/modeler/geometry/point_cloud.hpp"

namespace ribbon_mapper {
namespace {

void expect_moments_of(const Points& points, const Moments& moments) {
  EXPECT_NEAR(points.size(), moments.weight(), 1e-9);
  EXPECT_LT((slow_mean(points) - moments.mean()).norm(), 1e-12);
  EXPECT_LT((slow_covariance(points) - moments.covariance()).norm(), 1e-11);
}

const Points kFirst = cloud({0.5, 0.2, 0.01}, {3.0, -2.0, 1.0}, 50, 1);
const Points kSecond = cloud({0.1, 0.9, 0.3}, {-1.0, 4.0, 0.0}, 70, 2);

TEST(Moments, EqualThoseOfTheirPoints) { expect_moments_of(kFirst, moments_of(kFirst)); }

TEST(Moments, AddUpForAUnion) {
  Points both = kFirst;
  both.insert(both.end(), kSecond.begin(), kSecond.end());
  expect_moments_of(both, moments_of(kFirst) + moments_of(kSecond));
  expect_moments_of(kFirst, moments_of(both) - moments_of(kSecond));
}

TEST(Moments, AreTransformedWithTheirPoints) {
  const Pose T = Eigen::Translation3d(7.0, -3.0, 0.5) *
                 Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized());
  Points moved;
  for (const Eigen::Vector3d& p : kFirst) moved.push_back(T * p);
  expect_moments_of(moved, moments_of(kFirst).transformed(T));
  expect_moments_of(kFirst, moments_of(moved).transformed(T.inverse()));
}

TEST(Moments, KeepMeanAndCovarianceWhenScaled) {
  const Moments half = 0.5 * moments_of(kFirst);
  EXPECT_DOUBLE_EQ(25.0, half.weight());
  EXPECT_LT((half.mean() - slow_mean(kFirst)).norm(), 1e-12);
  EXPECT_LT((half.covariance() - slow_covariance(kFirst)).norm(), 1e-12);
}

TEST(Moments, SpreadEqualsPairsOfPoints) {
  const Eigen::Vector3d offset(0.1, -0.2, 0.3);
  Points pairs;
  for (const Eigen::Vector3d& p : kFirst) pairs.push_back(p + offset), pairs.push_back(p - offset);
  Moments spread = moments_of(kFirst);
  spread.spread(offset);
  expect_moments_of(pairs, 2.0 * spread);
}

TEST(Moments, GiveTheMeanSquareDistanceFromAPlane) {
  const Eigen::Vector3d normal = Eigen::Vector3d(1, -2, 2).normalized();
  double sum = 0.0;
  for (const Eigen::Vector3d& p : kFirst) sum += std::pow(normal.dot(p) + 0.7, 2);
  EXPECT_NEAR(sum / kFirst.size(), moments_of(kFirst).mean_square_distance(normal, 0.7), 1e-11);
}

}  // namespace
}  // namespace ribbon_mapper
