// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/orientation_grid.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "modeler/geometry/angles.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kCell_deg = 5.0;

/// Returns directions that are evenly distributed over the sphere (Fibonacci lattice).
std::vector<Eigen::Vector3d> even_normals(int count) {
  std::vector<Eigen::Vector3d> normals;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, turn = i * M_PI * (3.0 - std::sqrt(5.0));
    const double r = std::sqrt(1.0 - z * z);
    normals.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
  }
  return normals;
}

/// Returns normals of a face whose true normal is `axis`, with errors of about 1 degree.
std::vector<Eigen::Vector3d> noisy_normals(const Eigen::Vector3d& axis, int count) {
  std::mt19937 random(5);
  std::normal_distribution<double> error(0.0, 1.0 * kDegree);
  const Eigen::Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<Eigen::Vector3d> normals;
  for (int i = 0; i < count; ++i) {
    normals.push_back((axis + error(random) * u + error(random) * v).normalized());
  }
  return normals;
}

/// Returns the share of the votes in the fullest cell.
double share_of_peak(const std::vector<Eigen::Vector3d>& normals) {
  OrientationGrid grid(kCell_deg);
  for (const Eigen::Vector3d& normal : normals) grid.vote(normal, 1.0);
  return grid.peak().area_m2 / normals.size();
}

/// Returns the share of the votes in the fullest cell of a plain grid of 360 x 180 degrees.
double share_of_peak_of_plain_grid(const std::vector<Eigen::Vector3d>& normals) {
  std::map<std::pair<int, int>, int> votes;
  int max_votes = 0;
  for (const Eigen::Vector3d& n : normals) {
    const int azimuth =
        static_cast<int>(std::floor(std::atan2(n.y(), n.x()) / kDegree / kCell_deg));
    const int polar = static_cast<int>(std::floor(std::acos(n.z()) / kDegree / kCell_deg));
    max_votes = std::max(max_votes, ++votes[{azimuth, polar}]);
  }
  return static_cast<double>(max_votes) / normals.size();
}

TEST(OrientationGrid, HasCellsOfSimilarSolidAngle) {
  const OrientationGrid grid(kCell_deg);
  std::vector<int> hits(grid.cell_count(), 0);
  const int per_cell = 200, count = per_cell * static_cast<int>(grid.cell_count());
  for (const Eigen::Vector3d& normal : even_normals(count)) ++hits.at(grid.cell_of(normal));
  const auto [min_hits, max_hits] = std::minmax_element(hits.begin(), hits.end());
  EXPECT_GT(*min_hits, 0.7 * per_cell);
  EXPECT_LT(*max_hits, 1.3 * per_cell);
  EXPECT_NEAR(4.0 * M_PI / std::pow(kCell_deg * kDegree, 2), grid.cell_count(),
              0.05 * grid.cell_count());
}

TEST(OrientationGrid, HasACellForEveryDirection) {
  const OrientationGrid grid(kCell_deg);
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-1.0, -0.0, 0.0, 1.0}) {
      for (const double z : {-1.0, 0.0, 1.0}) {
        const Eigen::Vector3d n(x, y, z);
        if (n.norm() == 0.0) continue;
        EXPECT_LT(grid.cell_of(n.normalized()), grid.cell_count());
        EXPECT_LT(grid.cell_of(n.normalized() * (1.0 + 1e-9)), grid.cell_count());
      }
    }
  }
}

TEST(OrientationGrid, HasOnePeakForFloorAndCeilingAsForWalls) {
  const double floor = share_of_peak(noisy_normals(Eigen::Vector3d::UnitZ(), 2000));
  const double ceiling = share_of_peak(noisy_normals(-Eigen::Vector3d::UnitZ(), 2000));
  double walls = 0.0;
  for (int i = 0; i < 72; ++i) {
    const double azimuth = i * 5.0 * kDegree;
    const Eigen::Vector3d wall(std::cos(azimuth), std::sin(azimuth), 0.0);
    walls += share_of_peak(noisy_normals(wall, 2000)) / 72.0;
  }
  EXPECT_GT(floor, 0.9);
  EXPECT_GT(ceiling, 0.9);
  EXPECT_GE(floor, 0.95 * walls);
  // On a plain grid, a floor has no peak.
  const auto normals = noisy_normals(Eigen::Vector3d::UnitZ(), 2000);
  EXPECT_LT(share_of_peak_of_plain_grid(normals), 0.05);
}

TEST(OrientationGrid, HasAPeakAtTheNormalOfAFace) {
  for (const Eigen::Vector3d& axis : even_normals(50)) {
    OrientationGrid grid(kCell_deg);
    for (const Eigen::Vector3d& normal : noisy_normals(axis, 500)) grid.vote(normal, 0.01);
    EXPECT_GT(grid.peak().normal.dot(axis), std::cos(2.5 * kDegree));
    EXPECT_NEAR(1.0, grid.peak().normal.norm(), 1e-12);
  }
}

TEST(OrientationGrid, WeightsVotesByArea) {
  OrientationGrid grid(kCell_deg);
  for (int i = 0; i < 10; ++i) grid.vote(Eigen::Vector3d::UnitX(), 0.001);
  grid.vote(Eigen::Vector3d::UnitZ(), 0.02);
  EXPECT_NEAR(0.02, grid.peak().area_m2, 1e-12);
  EXPECT_GT(grid.peak().normal.z(), 0.999);
}

TEST(OrientationGrid, ForgetsWithdrawnVotes) {
  OrientationGrid grid(kCell_deg);
  const std::size_t x = grid.vote(Eigen::Vector3d::UnitX(), 0.5);
  const std::size_t y = grid.vote(Eigen::Vector3d::UnitY(), 0.25);
  EXPECT_EQ(grid.cell_of(Eigen::Vector3d::UnitX()), x);
  grid.withdraw(x, Eigen::Vector3d::UnitX(), 0.5);
  EXPECT_GT(grid.peak().normal.y(), 0.999);
  grid.withdraw(y, Eigen::Vector3d::UnitY(), 0.25);
  EXPECT_EQ(0.0, grid.peak().area_m2);
  grid.vote(Eigen::Vector3d::UnitX(), 0.5);
  grid.clear();
  EXPECT_EQ(0.0, grid.peak().area_m2);
}

TEST(OrientationGrid, IsIndependentOfTheOrderOfVotes) {
  OrientationGrid a(kCell_deg), b(kCell_deg);
  for (OrientationGrid* grid : {&a, &b}) {
    const bool is_first = grid == &a;
    grid->vote(is_first ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY(), 0.5);
    grid->vote(is_first ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX(), 0.5);
  }
  EXPECT_EQ(a.peak().normal, b.peak().normal);
}

}  // namespace
}  // namespace ribbon_mapper
