// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/surface/cell_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;

/// The sums of one cell in double precision.
struct SlowCell {
  double count = 0.0, sum = 0.0, square = 0.0;
  void add(double n, double distance, double own_square) {
    count += n, sum += n * distance, square += n * (distance * distance + own_square);
  }
};
using SlowGrid = std::map<std::pair<int, int>, SlowCell>;  // by (v, u)

Plane tilted_frame() {
  Plane frame;
  const Eigen::Quaterniond R(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()));
  frame.normal = R * Eigen::Vector3d::UnitZ();
  frame.axis_u = R * Eigen::Vector3d::UnitX();
  frame.axis_v = R * Eigen::Vector3d::UnitY();
  frame.d_m = 1.5;
  frame.origin = -1.5 * frame.normal;
  return frame;
}

/// Returns a ribbon between two random points near the origin of the frame, with noise of 1 cm, as
/// seen from a pose.
Ribbon scattered_ribbon(const Plane& frame, std::mt19937& random, const Pose& pose) {
  std::uniform_real_distribution<double> offset_m(-2.0, 2.0);
  std::normal_distribution<double> height_m(0.0, 0.01);
  const auto any = [&]() -> Eigen::Vector3d {
    return frame.origin + offset_m(random) * frame.axis_u + offset_m(random) * frame.axis_v;
  };
  const Eigen::Vector3d from = any(), to = any();
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 200; ++i) {
    points.push_back(pose.inverse() *
                     (from + (to - from) * i / 200.0 + height_m(random) * frame.normal));
  }
  return ribbon_of(points, pose.inverse().linear() * frame.normal);
}

/// Adds the samples of a ribbon one by one.
void add_slowly(const Ribbon& ribbon, const Pose& pose, const Plane& frame, SlowGrid& grid) {
  const PosedRibbon posed(ribbon, pose);
  ribbon.samples.for_each([&](float along_m, float sample_height_m, std::uint32_t count) {
    const Eigen::Vector3d p = posed.point(along_m, sample_height_m);
    const Eigen::Vector3d offset = p - frame.origin;
    const int u = static_cast<int>(std::floor(offset.dot(frame.axis_u) / frame.cell_size_m));
    const int v = static_cast<int>(std::floor(offset.dot(frame.axis_v) / frame.cell_size_m));
    grid[{v, u}].add(count, frame.normal.dot(p) + frame.d_m, ribbon.samples.variance_m2);
  });
}

/// Returns true if a cell has less than a twentieth of the count of a neighbour.
bool is_spill(const SlowGrid& grid, const std::pair<int, int>& key) {
  const auto has_twenty_times = [&](int v, int u) {
    const auto other = grid.find({v, u});
    return other != grid.end() && grid.at(key).count < 0.05 * other->second.count;
  };
  for (int d = 0; d < 9; ++d) {
    if (has_twenty_times(key.first + d / 3 - 1, key.second + d % 3 - 1)) return true;
  }
  return false;
}

TEST(CellGrid, AgreesWithASlowReference) {
  std::mt19937 random(4);
  const Plane frame = tilted_frame();
  const Pose pose = Eigen::Translation3d(3.0, -1.0, 0.2) *
                    Eigen::AngleAxisd(-1.1, Eigen::Vector3d(0, 1, 3).normalized());
  CellGrid grid(frame);
  SlowGrid slow;
  for (int i = 0; i < 200; ++i) {
    const Ribbon ribbon = scattered_ribbon(frame, random, pose);
    grid.add(PosedSamples(ribbon, pose));
    add_slowly(ribbon, pose, frame, slow);
  }
  const std::vector<PlaneCell> cells = grid.cells();
  ASSERT_GT(slow.size(), 3000u);
  std::size_t i = 0;
  for (const auto& [key, expected] : slow) {  // in the same order: by (v, u)
    if (is_spill(slow, key)) continue;
    ASSERT_LT(i, cells.size());
    const PlaneCell& cell = cells[i++];
    ASSERT_EQ(key, std::pair(cell.v, cell.u));
    const double mean = expected.sum / expected.count;
    EXPECT_EQ(expected.count, cell.count);
    EXPECT_NEAR(mean, cell.mean_m, 2e-6);
    EXPECT_NEAR(expected.square / expected.count - mean * mean, cell.variance_m2, 1e-7);
  }
  EXPECT_EQ(cells.size(), i);
}

TEST(CellGrid, OmitsCellsThatNoiseFilledBeyondAnEdge) {
  CellGrid grid(level_plane(1.0, {}));
  grid.add(Eigen::Vector3d(0.02, 0.02, 1.0), 100);
  grid.add(Eigen::Vector3d(0.07, 0.02, 1.0), 4);   // a neighbour with less than a twentieth
  grid.add(Eigen::Vector3d(-0.03, 0.02, 1.0), 6);  // a neighbour with more
  grid.add(Eigen::Vector3d(0.12, 0.02, 1.0), 1);   // one cell further
  const auto cells = grid.cells();
  ASSERT_EQ(3u, cells.size());
  EXPECT_EQ(6u, cells[0].count);
  EXPECT_EQ(100u, cells[1].count);
  EXPECT_EQ(1u, cells[2].count);
}

TEST(CellGrid, TreatsPointsLikeSamples) {
  const Plane frame = level_plane(1.0, {});
  CellGrid grid(frame);
  grid.add(Eigen::Vector3d(-0.01, 0.07, 1.02), 3);
  grid.add(Eigen::Vector3d(-0.02, 0.08, 0.99), 1);
  const auto cells = grid.cells();
  ASSERT_EQ(1u, cells.size());
  EXPECT_EQ(-1, cells[0].u);
  EXPECT_EQ(1, cells[0].v);
  EXPECT_EQ(4u, cells[0].count);
  EXPECT_NEAR(0.0125, cells[0].mean_m, 1e-6);
  EXPECT_NEAR((3 * 0.02 * 0.02 + 0.01 * 0.01) / 4 - 0.0125 * 0.0125, cells[0].variance_m2, 1e-7);
}

/// Returns the component of each cell by flood fill, numbered by first appearance.
std::vector<int> components_by_flood_fill(const std::vector<PlaneCell>& cells,
                                          double gap_in_cells) {
  std::vector<int> number(cells.size(), -1);
  int count = 0;
  for (std::size_t seed = 0; seed < cells.size(); ++seed) {
    if (number[seed] >= 0) continue;
    std::vector<std::size_t> open{seed};
    number[seed] = count;
    while (!open.empty()) {
      const PlaneCell a = cells[open.back()];
      open.pop_back();
      for (std::size_t j = 0; j < cells.size(); ++j) {
        if (number[j] >= 0) continue;
        if (std::hypot(a.u - cells[j].u, a.v - cells[j].v) > gap_in_cells) continue;
        number[j] = count;
        open.push_back(j);
      }
    }
    ++count;
  }
  return number;
}

TEST(ConnectedComponents, EqualThoseOfFloodFill) {
  std::mt19937 random(9);
  std::uniform_int_distribution<int> coordinate(-40, 40);
  for (const int gap : {1, 2, 3, 5, 6, 20}) {
    std::vector<PlaneCell> cells;
    for (int i = 0; i < 3000 / (gap * gap) + 20; ++i)
      cells.push_back({coordinate(random), coordinate(random), 1, 0, 0});
    std::sort(cells.begin(), cells.end(), [](const PlaneCell& a, const PlaneCell& b) {
      return std::pair(a.v, a.u) < std::pair(b.v, b.u);
    });
    const auto fast = connected_components(cells, 0.05, gap * 0.05);
    const auto slow = components_by_flood_fill(cells, gap);
    std::map<int, int> pairs;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      EXPECT_EQ(slow[i], pairs.emplace(fast[i], slow[i]).first->second) << "gap " << gap;
    }
    EXPECT_EQ(*std::max_element(slow.begin(), slow.end()) + 1, static_cast<int>(pairs.size()));
  }
}

TEST(ConnectedComponents, AreOrderedBySize) {
  std::vector<PlaneCell> cells = rectangle(2, 2);
  for (const PlaneCell& cell : rectangle(5, 5, 40, 0)) cells.push_back(cell);
  for (const PlaneCell& cell : rectangle(3, 3, 0, 40)) cells.push_back(cell);
  const auto numbers = connected_components(cells, 0.05, 0.3);
  EXPECT_EQ(2, numbers[0]);
  EXPECT_EQ(0, numbers[4]);
  EXPECT_EQ(1, numbers.back());
}

TEST(ConnectedComponents, MeasureGapsFromCentreToCentre) {
  for (const int gap_in_cells : {19, 20, 21, 22}) {
    std::vector<PlaneCell> cells = rectangle(3, 3);
    for (const PlaneCell& cell : rectangle(3, 3, 2 + gap_in_cells, 0)) cells.push_back(cell);
    const auto numbers = connected_components(cells, 0.05, 1.0);
    EXPECT_EQ(gap_in_cells <= 20, numbers[0] == numbers.back()) << gap_in_cells;
  }
}

}  // namespace
}  // namespace ribbon_mapper
