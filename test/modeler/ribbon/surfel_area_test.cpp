// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "modeler/ribbon/surfel.hpp"
#include "test/modeler/ribbon/three_lines.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;

/// Returns three lines at these tilts, with all ranges equal.
LineTriple lines_at(const std::array<double, 3>& tilts_rad, double range_m = 5.0,
                    std::size_t count = 721) {
  LaserBeams beams;
  beams.angle_min_rad = -M_PI_2;
  beams.angle_increment_rad = M_PI / (count - 1.0);
  beams.range_max_m = 30.0;
  beams.ranges_m.assign(count, static_cast<float>(range_m));
  std::vector<Line> lines;
  for (const double tilt_rad : tilts_rad) {
    const Pose pose = T_base_laser(tilt_rad);
    const LinePoses poses{Pose::Identity(), Pose::Identity(), pose, pose, Pose::Identity()};
    lines.push_back({beams, poses, Pose::Identity()});
  }
  return placed(lines);
}

/// Returns the area that a beam covers on a sphere around the laser between two tilts and azimuths.
double patch_m2(double range_m, double tilt_step_rad, double azimuth_rad, double beam_step_rad) {
  return range_m * range_m * tilt_step_rad *
         (std::sin(azimuth_rad + 0.5 * beam_step_rad) -
          std::sin(azimuth_rad - 0.5 * beam_step_rad));
}

TEST(SurfelArea, EqualsThePatchThatTheBeamCovers) {
  const double step_rad = 0.02;
  const LineTriple lines = lines_at({0.3, 0.3 + step_rad, 0.3 + 2.0 * step_rad});
  for (std::size_t beam = 1; beam < 720; ++beam) {
    const double azimuth = -M_PI_2 + beam * M_PI / 720.0;
    const double expected = patch_m2(5.0, step_rad, azimuth, M_PI / 720.0);
    EXPECT_NEAR(expected, surfel_area_m2(lines, beam), 1e-3 * expected) << "beam " << beam;
  }
}

TEST(SurfelArea, VanishesAtTheTiltAxis) {
  const LineTriple lines = lines_at({0.30, 0.32, 0.34});
  const double ahead_m2 = surfel_area_m2(lines, 360);
  EXPECT_LT(surfel_area_m2(lines, 0), 1e-6 * ahead_m2);
  EXPECT_LT(surfel_area_m2(lines, 720), 1e-6 * ahead_m2);
  EXPECT_NEAR(0.5 * ahead_m2, surfel_area_m2(lines, 120),
              1e-3 * ahead_m2);  // 60 degrees to the side
}

TEST(SurfelArea, GrowsWithTheSquareOfTheRange) {
  const double near_m2 = surfel_area_m2(lines_at({0.0, 0.01, 0.02}, 2.0), 300);
  EXPECT_NEAR(25.0 * near_m2, surfel_area_m2(lines_at({0.0, 0.01, 0.02}, 10.0), 300), 1e-9);
}

TEST(SurfelArea, IsSmallAtAReversal) {
  const double steady_m2 = surfel_area_m2(lines_at({0.00, 0.02, 0.04}), 360);
  EXPECT_LT(surfel_area_m2(lines_at({0.00, 0.02, 0.00}), 360), 1e-6 * steady_m2);
  EXPECT_NEAR(0.5 * steady_m2, surfel_area_m2(lines_at({0.00, 0.02, 0.02}), 360), 1e-3 * steady_m2);
}

TEST(SurfelArea, IsZeroForAStandingLaser) {
  EXPECT_EQ(0.0, surfel_area_m2(lines_at({0.1, 0.1, 0.1}), 360));
}

/// Returns the sum of all areas while the laser tilts as given, inside a sphere of 5 m radius.
double swept_m2(const std::function<double(double)>& tilt_at_share, int steps) {
  double sum = 0.0;
  for (int k = 0; k <= steps; ++k) {
    const LineTriple lines =
        lines_at({tilt_at_share((k - 1.0) / steps), tilt_at_share(k / static_cast<double>(steps)),
                  tilt_at_share((k + 1.0) / steps)},
                 5.0, 181);
    for (std::size_t beam = 0; beam < 181; ++beam) sum += surfel_area_m2(lines, beam);
  }
  return sum;
}

TEST(SurfelArea, AddsUpToTheSweptAreaForAnyTiltProfile) {
  const double amplitude = 0.8;
  const double band_m2 = 5.0 * 5.0 * 2.0 * amplitude * 2.0;  // of the sphere, 180 degrees wide
  const auto linear = [&](double share) { return amplitude * (2.0 * share - 1.0); };
  const auto sine = [&](double share) { return -amplitude * std::cos(M_PI * share); };
  EXPECT_NEAR(band_m2, swept_m2(linear, 80), 0.02 * band_m2);  // half a line at either end
  EXPECT_NEAR(band_m2, swept_m2(sine, 80), 0.005 * band_m2);
}

TEST(EstimateSurfels, CapsFarAreas) {
  const World wall{plane(-Eigen::Vector3d::UnitX(), 20.0)};
  const LineTriple lines = three_lines(wall, tilting(0.8));
  RibbonConfig config;
  std::vector<Surfel> surfels;
  estimate_surfels(lines, {}, config, surfels);
  ASSERT_FALSE(surfels.empty());
  for (std::size_t i = 0; i + 1 < surfels.size(); ++i) {
    const double stride = surfels[i + 1].beam - surfels[i].beam;
    EXPECT_GT(surfel_area_m2(lines, surfels[i].beam), config.area_cap_m2);
    EXPECT_NEAR(config.area_cap_m2 * stride, surfels[i].area_m2, 1e-12);
  }
}

TEST(EstimateSurfels, DoesNotCapNearAreas) {
  const World wall{plane(-Eigen::Vector3d::UnitX(), 1.0)};
  const LineTriple lines = three_lines(wall, tilting(0.8));
  std::vector<Surfel> surfels;
  estimate_surfels(lines, {}, {}, surfels);
  double sum = 0.0, all = 0.0;
  for (const Surfel& surfel : surfels) sum += surfel.area_m2;
  for (std::size_t i = 2; i < 359; ++i) {
    if (lines.middle.ranges_m[i] < 2.0F && lines.middle.has_return(i)) {
      all += surfel_area_m2(lines, i);
    }
  }
  EXPECT_GT(sum, 0.9 * all);  // a surfel includes the beams that it skips
}

}  // namespace
}  // namespace ribbon_mapper
