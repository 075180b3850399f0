// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/no_return_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ribbon_mapper {
namespace {

constexpr std::size_t kBeams = 361;
constexpr double kStep_rad = M_PI / 360.0;

/// Returns a line of a wall at 3 m, seen over 180 degrees, with beams beyond 8 m at `nothing_m`.
LaserBeams wall_line(float nothing_m, double sigma_m, double resolution_m, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, 1.0);
  LaserBeams beams;
  beams.angle_min_rad = -M_PI_2, beams.angle_increment_rad = kStep_rad;
  beams.range_min_m = 0.1, beams.range_max_m = 30.0;
  for (std::size_t i = 0; i < kBeams; ++i) {
    const double bearing = beams.angle_min_rad + static_cast<double>(i) * kStep_rad;
    double range_m = 3.0 / std::max(1e-3, std::cos(bearing)) + sigma_m * noise(random);
    if (resolution_m > 0.0) range_m = resolution_m * std::round(range_m / resolution_m);
    beams.ranges_m.push_back(range_m > 8.0 ? nothing_m : static_cast<float>(range_m));
  }
  return beams;
}

std::size_t infinite(const LaserBeams& beams) {
  return static_cast<std::size_t>(std::count_if(beams.ranges_m.begin(), beams.ranges_m.end(),
                                                [](float range_m) { return std::isinf(range_m); }));
}

TEST(NoReturnFilter, RemovesARangeThatNoSurfaceHas) {
  // Anywhere: at the end of the range, just below, in the middle of true ranges.
  for (const float nothing_m : {30.0F, 29.99F, 8.1F, 5.0F, 3.5F}) {
    std::mt19937 random(1);
    NoReturnFilter filter{ScanConfig{}};
    std::size_t removed = 0, all = 0;
    for (int i = 0; i < 20; ++i) {
      const LaserBeams beams = wall_line(nothing_m, 0.01, 0.0, random);
      all += static_cast<std::size_t>(
          std::count(beams.ranges_m.begin(), beams.ranges_m.end(), nothing_m));
      removed += infinite(filter.filter(beams));
    }
    const auto found = filter.found();
    ASSERT_TRUE(found) << nothing_m;
    EXPECT_EQ(nothing_m, found->range_m);
    EXPECT_EQ(removed, found->beams);
    EXPECT_GE(removed + 2 * all / 20 + 2, all) << "from the third line on";
    EXPECT_NEAR(static_cast<double>(removed) / (20.0 * kBeams), found->share, 1e-9);
  }
}

TEST(NoReturnFilter, NeedsASingleLineAtTheEndOfTheRange) {
  std::mt19937 random(1);
  NoReturnFilter filter{ScanConfig{}};
  EXPECT_GT(infinite(filter.filter(wall_line(30.0F, 0.01, 0.0, random))), 50u);
}

TEST(NoReturnFilter, KeepsSurfacesOfAnyResolutionAndNoise) {
  for (const double resolution_m : {0.0, 0.001, 0.005, 0.01}) {
    for (const double sigma_m : {0.0, 0.002, 0.01, 0.03}) {
      std::mt19937 random(1);
      NoReturnFilter filter{ScanConfig{}};
      for (int i = 0; i < 200; ++i) {
        const LaserBeams beams = wall_line(INFINITY, sigma_m, resolution_m, random);
        EXPECT_EQ(&beams, &filter.filter(beams));
      }
      EXPECT_FALSE(filter.found()) << resolution_m << " m, noise " << sigma_m << " m";
    }
  }
}

/// A leg before a wall, as lasers with a resolution of a centimetre see it for some seconds.
TEST(NoReturnFilter, KeepsAThinObject) {
  std::mt19937 random(1);
  NoReturnFilter filter{ScanConfig{}};
  for (int i = 0; i < 300; ++i) {
    LaserBeams beams = wall_line(INFINITY, 0.01, 0.01, random);
    if (i > 200 && i < 230) std::fill_n(beams.ranges_m.begin() + 180, 8, 0.49F);
    filter.filter(beams);
  }
  EXPECT_FALSE(filter.found());
}

TEST(NoReturnFilter, KeepsLinesWithoutRangesAndWithoutNumbers) {
  NoReturnFilter filter{ScanConfig{}};
  LaserBeams beams;
  beams.angle_increment_rad = kStep_rad, beams.range_max_m = 30.0;
  for (const float range_m : {NAN, INFINITY, -INFINITY, 0.0F, -1.0F, 1e9F}) {
    beams.ranges_m.assign(kBeams, range_m);
    for (int i = 0; i < 10; ++i) filter.filter(beams);
  }
  beams.ranges_m.clear();
  filter.filter(beams);
  EXPECT_FALSE(filter.found());
}

}  // namespace
}  // namespace ribbon_mapper
