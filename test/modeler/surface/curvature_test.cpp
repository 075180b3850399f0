// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/surface/curvature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;

/// Returns a plane whose cells measure a cylinder of this curvature, with noise. The axis of the
/// cylinder is rotated by `turn_rad` from the longer side.
Plane bent_plane(double bend, double turn_rad, double noise_m, unsigned seed = 1, int columns = 12,
                 int rows = 30) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, noise_m);
  Plane plane = level_plane(0.5, rectangle(columns, rows));
  for (PlaneCell& cell : plane.cells) {
    const Eigen::Vector3d offset = cell_centre(plane, cell) - plane.centroid;
    const double across = std::cos(turn_rad) * offset.x() + std::sin(turn_rad) * offset.y();
    cell.count = 10;
    cell.mean_m = static_cast<float>(-0.5 * bend * across * across + noise(random));
  }
  return plane;
}

TEST(Curvature, IsThatOfACylinderInAnyDirection) {
  for (const double bend : {4.0, 1.0, -2.0}) {
    for (const double turn_rad : {0.0, 0.5, M_PI_2, 2.0}) {
      const Curvature curvature = curvature_of(bent_plane(bend, turn_rad, 1e-4));
      EXPECT_NEAR(std::abs(bend), curvature.bend, 0.02 * std::abs(bend));
    }
  }
}

TEST(Curvature, HasTheSagittaOfItsWidth) {
  // 12 cells of 5 cm make 0.6 m.
  EXPECT_NEAR(2.0 * 0.6 * 0.6 / 8.0, curvature_of(bent_plane(2.0, 0.0, 1e-4)).sagitta_m, 2e-3);
  EXPECT_NEAR(2.0 * 1.5 * 1.5 / 8.0, curvature_of(bent_plane(2.0, M_PI_2, 1e-4)).sagitta_m, 2e-2);
}

TEST(Curvature, PredictsItsError) {
  for (const double turn_rad : {0.0, M_PI_4}) {
    double square = 0.0, predicted = 0.0;
    const int runs = 1000;
    for (int run = 0; run < runs; ++run) {
      const Curvature curvature = curvature_of(bent_plane(3.0, turn_rad, 0.004, run, 20, 20));
      square += std::pow(curvature.bend - 3.0, 2) / runs;
      predicted += curvature.sigma / runs;
    }
    EXPECT_NEAR(std::sqrt(square), predicted, 0.08 * predicted);
  }
}

TEST(Curvature, IsInsignificantForAPlane) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Curvature curvature = curvature_of(bent_plane(0.0, 0.0, 0.004, seed));
    EXPECT_LT(curvature.bend, 5.0 * curvature.sigma);
  }
}

TEST(Curvature, IsUnknownForFewCells) {
  Plane plane = level_plane(0.0, rectangle(11, 1));
  EXPECT_TRUE(std::isinf(curvature_of(plane).sigma));
}

}  // namespace
}  // namespace ribbon_mapper
