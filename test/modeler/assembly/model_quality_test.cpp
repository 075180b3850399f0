// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/model_quality.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ribbon_mapper {
namespace {

/// Returns a square of cells in the plane z = `height_m`, whose first column is `u0`.
Plane square_plane(double height_m, int u0 = 0, int side = 20) {
  Plane plane;
  plane.d_m = -height_m;
  plane.origin = {0.0, 0.0, height_m};
  for (int v = 0; v < side; ++v) {
    for (int u = u0; u < u0 + side; ++u) plane.cells.push_back({u, v, 4, 0.0F, 1e-4F});
  }
  plane.area_m2 = plane.cells.size() * 0.0025;
  plane.centroid = cell_centre(plane, plane.cells[plane.cells.size() / 2]);
  return plane;
}

TEST(Duplicates, AreNearParallelAndTouching) {
  const DuplicateRule rule;
  EXPECT_TRUE(duplicates_of_larger({square_plane(0.0), square_plane(0.2)}, rule).empty());
  EXPECT_TRUE(duplicates_of_larger({square_plane(0.0), square_plane(0.05, 40)}, rule).empty());
  const auto found = duplicates_of_larger({square_plane(0.05, 22, 10), square_plane(0.0)}, rule);
  EXPECT_EQ(found, std::vector<std::size_t>{0});
}

TEST(Duplicates, ExcludeTheBackOfAThinWall) {
  Plane back = square_plane(0.05, 0, 10);
  back.normal *= -1.0, back.d_m *= -1.0;
  EXPECT_TRUE(duplicates_of_larger({square_plane(0.0), back}, {}).empty());
}

TEST(Residual, IsTheMedianOverThePoints) {
  EXPECT_FALSE(median_residual_m({}).has_value());
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.012);
  std::vector<double> distances;
  Plane plane = square_plane(0.0);
  for (PlaneCell& cell : plane.cells) {
    double sum = 0.0, squares = 0.0;
    const double bias = 0.01 * std::sin(0.3 * cell.u);
    cell.count = 30;
    for (std::uint32_t i = 0; i < cell.count; ++i) {
      const double d = bias + noise(random);
      sum += d, squares += d * d, distances.push_back(std::abs(d));
    }
    cell.mean_m = static_cast<float>(sum / cell.count);
    cell.variance_m2 = static_cast<float>(squares / cell.count - cell.mean_m * cell.mean_m);
  }
  std::sort(distances.begin(), distances.end());
  EXPECT_NEAR(*median_residual_m({plane}), distances[distances.size() / 2], 3e-4);
  EXPECT_EQ(point_count({plane}), distances.size());
}

}  // namespace
}  // namespace ribbon_mapper
