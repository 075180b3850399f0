// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/surface/outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;
using Cells = std::vector<PlaneCell>;

const double kStripeGap_m = SurfaceConfig{}.stripe_gap_m;

Cells operator+(Cells a, const Cells& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Returns the area of a ring on a plane, positive if it is counter-clockwise about the normal.
double area_m2(const Plane& plane, const std::vector<Eigen::Vector3d>& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    twice += ring[i].cross(ring[(i + 1) % ring.size()]).dot(plane.normal);
  }
  return 0.5 * twice;
}

double area_m2(const Plane& plane, const std::vector<Outline>& outlines) {
  double sum = 0.0;
  for (const Outline& outline : outlines) {
    sum += area_m2(plane, outline.outer);
    for (const auto& hole : outline.holes) sum += area_m2(plane, hole);
  }
  return sum;
}

/// Returns the outlines with stripes of up to `stripe_gap_m` closed.
std::vector<Outline> outlines(const Plane& plane, double stripe_gap_m) {
  SurfaceConfig config;
  config.stripe_gap_m = stripe_gap_m;
  return outlines_of(plane, config);
}

/// Returns the one outline of a plane, which has no holes.
std::vector<Eigen::Vector3d> outline(const Plane& plane, double stripe_gap_m) {
  const std::vector<Outline> all = outlines(plane, stripe_gap_m);
  EXPECT_EQ(1u, all.size());
  EXPECT_TRUE(all.at(0).holes.empty());
  return all.at(0).outer;
}

/// Returns a rectangle of `columns` x `rows` cells without the one that `hole` covers.
Cells without(int columns, int rows, const Cells& hole) {
  Cells cells;
  for (const PlaneCell& cell : rectangle(columns, rows)) {
    const auto same = [&](const PlaneCell& other) {
      return other.u == cell.u && other.v == cell.v;
    };
    if (std::none_of(hole.begin(), hole.end(), same)) cells.push_back(cell);
  }
  return cells;
}

TEST(Outline, OfARectangleHasItsFourCorners) {
  const Plane plane = level_plane(0.7, rectangle(20, 10, -5, 3));
  const auto ring = outline(plane, 0.3);
  ASSERT_EQ(4u, ring.size());
  EXPECT_NEAR(1.0 * 0.5, area_m2(plane, ring), 1e-9);
  for (const Eigen::Vector3d& corner : ring) {
    EXPECT_NEAR(0.7, corner.z(), 1e-9);
    EXPECT_TRUE(std::abs(corner.x() + 0.25) < 1e-9 || std::abs(corner.x() - 0.75) < 1e-9);
    EXPECT_TRUE(std::abs(corner.y() - 0.15) < 1e-9 || std::abs(corner.y() - 0.65) < 1e-9);
  }
}

TEST(Outline, OfAnLHasSixCorners) {
  const Plane plane = level_plane(0.0, rectangle(60, 20) + rectangle(20, 40, 0, 20));
  const auto ring = outline(plane, 0.1);
  EXPECT_EQ(6u, ring.size());
  EXPECT_NEAR(plane.area_m2, area_m2(plane, ring), 1e-9);
}

TEST(Outline, KeepsNotchesDeeperThanTheTolerance) {
  for (const int depth : {1, 3}) {
    const Plane plane = level_plane(
        0.0, rectangle(60, 40) + rectangle(20, depth, 0, 40) + rectangle(20, depth, 40, 40));
    SurfaceConfig config;
    config.stripe_gap_m = 0.1, config.outline_tolerance_m = 0.06;
    EXPECT_EQ(depth == 1 ? 4u : 8u, outlines_of(plane, config).at(0).outer.size());
  }
}

TEST(Outline, ClosesStripesBetweenLines) {
  Cells stripes;
  for (int v = 0; v < 40; v += 5) stripes = stripes + rectangle(40, 1, 0, v);
  const Plane plane = level_plane(0.0, stripes);
  const auto ring = outline(plane, 0.5);
  EXPECT_EQ(4u, ring.size());
  EXPECT_NEAR(2.0 * 36 * 0.05, area_m2(plane, ring), 1e-9);
}

TEST(Outline, LeavesAWindowOpen) {
  const Plane plane = level_plane(0.0, without(60, 60, rectangle(20, 20, 20, 20)));
  const auto all = outlines(plane, 0.3);
  ASSERT_EQ(1u, all.size());
  EXPECT_EQ(4u, all[0].outer.size());
  ASSERT_EQ(1u, all[0].holes.size());
  EXPECT_EQ(4u, all[0].holes[0].size());
  EXPECT_NEAR(-1.0, area_m2(plane, all[0].holes[0]), 1e-9);  // clockwise
  EXPECT_NEAR(plane.area_m2, area_m2(plane, all), 1e-9);
}

/// A wall of 4 m x 2.5 m with a door of 0.7 m x 2 m: columns are along the floor.
TEST(Outline, LeavesADoorOpen) {
  const Plane plane = level_plane(0.0, without(80, 50, rectangle(14, 40, 30, 0)));
  const auto ring = outline(plane, 0.3);
  EXPECT_EQ(8u, ring.size());
  EXPECT_NEAR(plane.area_m2, area_m2(plane, ring), 1e-9);
}

TEST(Outline, OfSeparatePartsEnclosesEach) {
  const Plane plane = level_plane(0.0, rectangle(10, 10) + rectangle(30, 30, 100, 0));
  EXPECT_EQ(2u, outlines(plane, 0.3).size());
  EXPECT_NEAR(plane.area_m2, area_m2(plane, outlines(plane, 0.3)), 1e-9);
}

TEST(Outline, LeavesOutPartsAndHolesThatLinesDoNotResolve) {
  const Cells wall = without(60, 60, rectangle(5, 5, 20, 20));
  const Plane plane = level_plane(0.0, wall + rectangle(5, 5, 80, 0));
  EXPECT_NEAR(3.0 * 3.0, area_m2(plane, outline(plane, 0.3)), 1e-9);
}

TEST(Outline, OfNoCellsIsEmpty) { EXPECT_TRUE(outlines(level_plane(0.0, {}), 1.0).empty()); }

TEST(Outline, OfFewCellsIsTheirBorder) {
  const Plane plane = level_plane(0.0, rectangle(2, 2, 7, -9));
  EXPECT_NEAR(0.1 * 0.1, area_m2(plane, outline(plane, 1.0)), 1e-9);
}

TEST(Outline, JoinsCellsThatTouchAtACorner) {
  for (const Cells& second : {rectangle(10, 10, 10, 10), rectangle(10, 10, -10, 10)}) {
    const Plane plane = level_plane(0.0, rectangle(10, 10) + second);
    SurfaceConfig exact;
    exact.stripe_gap_m = 0.0, exact.outline_tolerance_m = 0.001;
    const auto all = outlines_of(plane, exact);
    EXPECT_EQ(1u, all.size());
    EXPECT_NEAR(plane.area_m2 + 0.05 * 0.05, area_m2(plane, all), 1e-9);
  }
}

/// Cells at random touch in every way. All the seen ones are inside, and few others.
TEST(Outline, OfCellsAtRandomEnclosesThem) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    Cells cells;
    for (const PlaneCell& cell : rectangle(130, 40)) {
      if (random() % 10 < 6) cells.push_back(cell);
    }
    const Plane plane = level_plane(0.0, cells);
    const Polygons exact = seen_area(plane, 0.0, 0.0);
    EXPECT_GE(area(exact), plane.area_m2 - 1e-9);
    EXPECT_LE(area(exact), 1.35 * plane.area_m2);
    std::size_t holes = 0;
    for (const Polygon& polygon : exact) holes += polygon.holes.size();
    EXPECT_GT(holes, 1u);
  }
}

/// Returns the cells of all rectangles. Expects each to be in one rectangle only.
std::set<std::pair<int, int>> cells_of(const std::vector<CellRectangle>& rectangles) {
  std::set<std::pair<int, int>> cells;
  for (const CellRectangle& r : rectangles) {
    for (int v = r.v_begin; v < r.v_end; ++v) {
      for (int u = r.u_begin; u < r.u_end; ++u) EXPECT_TRUE(cells.emplace(u, v).second);
    }
  }
  return cells;
}

TEST(SurfaceRectangles, CoverEachCellOnce) {
  std::mt19937 random(2);
  Cells cells;
  std::set<std::pair<int, int>> expected;
  for (const PlaneCell& cell : rectangle(30, 30, -10, -20)) {
    if (random() % 3 == 0) continue;
    cells.push_back(cell);
    expected.emplace(cell.u, cell.v);
  }
  EXPECT_EQ(expected, cells_of(surface_rectangles(level_plane(0.0, cells), 0.0)));
}

TEST(SurfaceRectangles, AreFew) {
  EXPECT_EQ(1u, surface_rectangles(level_plane(0.0, rectangle(50, 30)), kStripeGap_m).size());
  Cells stripes;
  for (int v = 0; v < 40; v += 5) stripes = stripes + rectangle(40, 1, 0, v);
  EXPECT_EQ(1u, surface_rectangles(level_plane(0.0, stripes), kStripeGap_m).size());
  EXPECT_EQ(8u, surface_rectangles(level_plane(0.0, stripes), 0.1).size());
  EXPECT_TRUE(surface_rectangles(level_plane(0.0, {}), kStripeGap_m).empty());
}

using Position = std::pair<int, int>;
using Positions = std::set<Position>;

/// Calls function(position) for all positions in a square around one, up to the margin.
template <typename Function>
void for_each_around(const Position& position, int margin, const Function& function) {
  for (int du = -margin; du <= margin; ++du) {
    for (int dv = -margin; dv <= margin; ++dv)
      function(Position(position.first + du, position.second + dv));
  }
}

/// Returns the morphological closing by its definition.
Positions closed_slowly(const Positions& positions, int margin) {
  Positions dilated, closed;
  for (const Position& position : positions) {
    for_each_around(position, margin, [&](const Position& around) { dilated.insert(around); });
  }
  for (const Position& position : dilated) {
    bool is_inside = true;
    for_each_around(position, margin,
                    [&](const Position& around) { is_inside &= dilated.count(around) > 0; });
    if (is_inside) closed.insert(position);
  }
  return closed;
}

TEST(SurfaceRectangles, CloseGapsLikeASlowReference) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> column(-50, 60), row(-9, 20);
  for (const int margin : {0, 1, 2, 5, 9}) {
    Cells cells;
    Positions positions;
    for (int i = 0; i < 150; ++i) {
      cells.push_back({column(random), row(random), 1, 0, 0});
      positions.emplace(cells.back().u, cells.back().v);
    }
    EXPECT_EQ(closed_slowly(positions, margin),
              cells_of(surface_rectangles(level_plane(0.0, cells), 2.0 * margin * 0.05 + 0.001)))
        << margin;
  }
}

TEST(SurfaceRectangles, CloseGapsOfMoreThan64Cells) {
  const Plane plane = level_plane(0.0, rectangle(1, 40, -30, 0) + rectangle(1, 40, 101, 0));
  const auto rectangles = surface_rectangles(plane, 7.01);
  ASSERT_EQ(1u, rectangles.size());
  EXPECT_EQ(132, rectangles[0].u_end - rectangles[0].u_begin);
  EXPECT_EQ(2u, surface_rectangles(plane, 6.41).size());
}

}  // namespace
}  // namespace ribbon_mapper
