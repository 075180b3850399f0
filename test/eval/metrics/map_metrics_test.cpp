// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/metrics/map_metrics.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <random>

namespace ribbon_mapper::eval {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Returns a wall at y = `y_m`, 2 m high, with cells of 5 cm from `x_begin_m` to `x_end_m`. It
/// faces -y for `side` -1.
Patch wall(double x_begin_m, double x_end_m, double y_m = 3.0, double side = -1.0) {
  Patch patch;
  patch.normal = {0.0, side, 0.0};
  patch.d_m = -side * y_m;
  for (double x = x_begin_m + 0.025; x < x_end_m; x += 0.05) {
    for (double z = 0.025; z < 2.0; z += 0.05) patch.cells.emplace_back(x, y_m, z);
  }
  patch.area_m2 = 0.0025 * static_cast<double>(patch.cells.size());
  return patch;
}

/// Rotates a patch about the vertical axis through `centre`.
Patch turned(Patch patch, double angle_deg, const Eigen::Vector3d& centre) {
  const Eigen::AngleAxisd rotation(angle_deg * M_PI / 180.0, Eigen::Vector3d::UnitZ());
  patch.normal = rotation * patch.normal;
  for (Eigen::Vector3d& cell : patch.cells) cell = centre + rotation * (cell - centre);
  patch.d_m = -patch.normal.dot(centre);
  return patch;
}

TEST(MapMetrics, APerfectModel) {
  const std::vector<Patch> truth{wall(0, 4), wall(6, 8), wall(0, 4, 5.0)};
  const MapMetrics m = compare_maps(truth, truth);
  EXPECT_EQ(m.matched, 3U);
  EXPECT_THAT(m.missed, IsEmpty());
  EXPECT_THAT(m.extra, IsEmpty());
  EXPECT_THAT(m.duplicates, IsEmpty());
  EXPECT_DOUBLE_EQ(m.f1, 1.0);
  EXPECT_DOUBLE_EQ(m.coverage, 1.0);
  EXPECT_NEAR(m.angle_error_deg_mean.value(), 0.0, 1e-9);
  EXPECT_NEAR(m.offset_error_m_mean.value(), 0.0, 1e-9);
}

TEST(MapMetrics, OneMissed) {
  const MapMetrics m = compare_maps({wall(0, 4)}, {wall(0, 4), wall(6, 8)});
  EXPECT_EQ(m.matched, 1U);
  EXPECT_THAT(m.missed, ElementsAre(1U));
  EXPECT_DOUBLE_EQ(m.precision, 1.0);
  EXPECT_DOUBLE_EQ(m.recall, 0.5);
  EXPECT_DOUBLE_EQ(m.f1, 2.0 / 3.0);
  EXPECT_NEAR(m.coverage, 4.0 / 6.0, 1e-9);
}

TEST(MapMetrics, OneExtra) {
  const MapMetrics m = compare_maps({wall(0, 4), wall(20, 24)}, {wall(0, 4)});
  EXPECT_EQ(m.matched, 1U);
  EXPECT_THAT(m.extra, ElementsAre(1U));
  EXPECT_THAT(m.duplicates, IsEmpty());
  EXPECT_DOUBLE_EQ(m.precision, 0.5);
}

TEST(MapMetrics, OneSplitInTwo) {
  const MapMetrics m = compare_maps({wall(0, 1.5), wall(1.5, 4)}, {wall(0, 4)});
  EXPECT_EQ(m.matched, 1U);
  EXPECT_THAT(m.duplicates, ElementsAre(0U)) << "the larger part is the match";
  EXPECT_THAT(m.extra, IsEmpty());
  EXPECT_DOUBLE_EQ(m.coverage, 1.0);
  EXPECT_DOUBLE_EQ(m.precision, 0.5);
}

TEST(MapMetrics, TwoJoined) {
  const MapMetrics m = compare_maps({wall(0, 4)}, {wall(0, 1.5), wall(1.5, 4)});
  EXPECT_EQ(m.matched, 1U);
  EXPECT_THAT(m.missed, ElementsAre(0U));
  EXPECT_THAT(m.duplicates, IsEmpty());
  EXPECT_DOUBLE_EQ(m.coverage, 1.0);
}

TEST(MapMetrics, OneDoubledByDrift) {
  const MapMetrics m = compare_maps({wall(0, 4, 3.02), wall(0, 4, 3.08)}, {wall(0, 4)});
  EXPECT_EQ(m.matched, 1U);
  EXPECT_THAT(m.duplicates, ElementsAre(1U)) << "the nearer one is the match";
  EXPECT_NEAR(m.offset_error_m_mean.value(), 0.02, 1e-9);
}

TEST(MapMetrics, ADoubleFurtherThanTheOffsetIsExtra) {
  const MapMetrics m = compare_maps({wall(0, 4), wall(0, 4, 3.12)}, {wall(0, 4)});
  EXPECT_THAT(m.extra, ElementsAre(1U));
}

TEST(MapMetrics, TwoSidesOfAThinWallAreTwoPlanes) {
  const Patch front = wall(0, 4, 3.0, -1.0), back = wall(0, 4, 3.05, 1.0);
  const MapMetrics both = compare_maps({back, front}, {front, back});
  EXPECT_EQ(both.matched, 2U);
  const MapMetrics one = compare_maps({back}, {front});
  EXPECT_EQ(one.matched, 0U);
  EXPECT_THAT(one.missed, ElementsAre(0U));
  EXPECT_THAT(one.extra, ElementsAre(0U));
  EXPECT_DOUBLE_EQ(one.coverage, 0.0);
}

TEST(MapMetrics, AngleAndOffsetAreMeasuredAtTheCentroid) {
  const Eigen::Vector3d centre(102.0, 3.0,
                               1.0);  // far from the origin, where d depends on the angle
  const MapMetrics m = compare_maps({turned(wall(100, 104), 2.0, centre)}, {wall(100, 104)});
  ASSERT_EQ(m.matched, 1U);
  EXPECT_NEAR(m.angle_error_deg_mean.value(), 2.0, 1e-9);
  EXPECT_NEAR(m.offset_error_m_mean.value(), 0.0, 1e-9);
  EXPECT_EQ(compare_maps({turned(wall(100, 104), 5.1, centre)}, {wall(100, 104)}).matched, 0U);
}

TEST(MapMetrics, AQuarterOfAWallIsMatchedByWhatItCovers) {
  const MapMetrics m = compare_maps({wall(0, 1)}, {wall(0, 4)});
  EXPECT_EQ(m.matched, 1U);
  EXPECT_NEAR(m.coverage, 0.25, 0.02) << "the reach of 7.5 cm widens the edge by one cell";
}

TEST(MapMetrics, ASmallSharedPartIsNoMatch) {
  EXPECT_EQ(compare_maps({wall(0, 4)}, {wall(3, 7)}).matched, 0U);
}

// Tests each of MatchLimits from both sides.
TEST(MapMetrics, LimitsAreFiveDegreesTenCentimetresAndHalfOfEither) {
  const Patch truth = wall(0, 4);
  const auto matches = [&](const Patch& estimate) {
    return compare_maps({estimate}, {truth}).matched == 1;
  };
  EXPECT_TRUE(matches(turned(truth, 4.9, {2.0, 3.0, 1.0})));
  EXPECT_FALSE(matches(turned(truth, 5.1, {2.0, 3.0, 1.0})));
  EXPECT_TRUE(matches(wall(0, 4, 3.099)));
  EXPECT_FALSE(matches(wall(0, 4, 3.101)));
  EXPECT_TRUE(matches(wall(2 - 0.25, 6 - 0.25)));
  EXPECT_FALSE(matches(wall(2 + 0.25, 6 + 0.25)));
  EXPECT_TRUE(matches(wall(-20, 2.25))) << "half of the truth suffices";
}

// Matches are one to one: an estimate cannot match two true planes.
TEST(MapMetrics, AnEstimateOverTwoTruthsWithTheirOwnEstimatesIsADuplicate) {
  const MapMetrics m = compare_maps({wall(0, 2), wall(2, 4), wall(0, 4)}, {wall(0, 2), wall(2, 4)});
  EXPECT_EQ(m.matched, 2U);
  EXPECT_THAT(m.duplicates, ElementsAre(2U));
  EXPECT_THAT(m.missed, IsEmpty());
}

TEST(MapMetrics, EmptyModelsAndWorlds) {
  const MapMetrics nothing = compare_maps({}, {wall(0, 4)});
  EXPECT_EQ(nothing.f1, 0.0);
  EXPECT_FALSE(nothing.angle_error_deg_mean.has_value());
  EXPECT_EQ(compare_maps({wall(0, 4)}, {}).extra.size(), 1U);
  EXPECT_EQ(compare_maps({}, {}).precision, 0.0);
  EXPECT_EQ(compare_maps({Patch()}, {wall(0, 4)}).matched, 0U);
}

TEST(MapMetrics, OverlapAgreesWithTheSlowDefinition) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0.0, 3.0);
  Patch estimate = wall(0, 0), truth = wall(0, 0);
  for (int i = 0; i < 400; ++i) estimate.cells.emplace_back(place(random), 3.0, place(random));
  for (int i = 0; i < 300; ++i) truth.cells.emplace_back(place(random), 3.0, place(random));
  truth.area_m2 = 1.0;
  const auto is_covered = [&](const Eigen::Vector3d& cell) {
    return std::any_of(
        estimate.cells.begin(), estimate.cells.end(),
        [&](const Eigen::Vector3d& other) { return (other - cell).norm() <= 0.075; });
  };
  const auto covered = std::count_if(truth.cells.begin(), truth.cells.end(), is_covered);
  EXPECT_DOUBLE_EQ(compare_maps({estimate}, {truth}).coverage,
                   static_cast<double>(covered) / static_cast<double>(truth.cells.size()));
}

}  // namespace
}  // namespace ribbon_mapper::eval
