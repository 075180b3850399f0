// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/chain/pose_precision.hpp"

#include <gtest/gtest.h>

#include "modeler/geometry/angles.hpp"

namespace ribbon_mapper {
namespace {

/// A covariance of standard deviations of a position, in each direction, and of the heading.
Matrix6 covariance_of(double sigma_m, double heading_deg) {
  Matrix6 covariance = Matrix6::Identity();
  covariance.topLeftCorner<3, 3>() *= sigma_m * sigma_m;
  covariance(5, 5) = heading_deg * kDegree * heading_deg * kDegree;
  return covariance;
}

TEST(PosePrecision, IsMedianAndLargestOfDistanceAndHeading) {
  const PosePrecision precision =
      precision_of({covariance_of(3.0, 1.0), covariance_of(1.0, 5.0), covariance_of(2.0, 4.0)});
  EXPECT_NEAR(precision.position_m_median, 2.0 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(precision.position_m_largest, 3.0 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(precision.heading_deg_median, 4.0, 1e-12);
  EXPECT_NEAR(precision.heading_deg_largest, 5.0, 1e-12);
}

TEST(PosePrecision, HasNamesForSummaries) {
  const auto named = named_sigmas({1.0, 2.0, 3.0, 4.0});
  EXPECT_STREQ(named[0].first, "position_sigma_m_median");
  EXPECT_STREQ(named[3].first, "heading_sigma_deg_largest");
  for (std::size_t i = 0; i < named.size(); ++i)
    EXPECT_EQ(named[i].second, static_cast<double>(i + 1));
}

TEST(PosePrecision, OfNothingIsZero) { EXPECT_EQ(precision_of({}).position_m_largest, 0.0); }

}  // namespace
}  // namespace ribbon_mapper
