// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "modeler/semantics/semantics.hpp"
#include "test/modeler/semantics/rectangles.hpp"

namespace ribbon_mapper {
namespace {

using namespace rectangles;
using Eigen::AlignedBox3d;
using Eigen::Vector3d;

/// Returns the cells in an opening of a wall at y = 5.
AlignedBox3d gap(double x, double width, double bottom = -1.0, double top = 2.1) {
  return {Vector3d(x, 4, bottom), Vector3d(x + width, 6, top)};
}

/// Returns a wall of 6 m at y = 5 with an opening from x = 2 on.
Plane wall_with_gap(double width, double bottom = -1.0, double top = 2.1) {
  return without(upright(0, 5, 6, 0, 2.6, 7), gap(2, width, bottom, top));
}

/// Returns a floor that goes through the wall at y = 5 from x to x + width only. Walls are 10 cm
/// thick.
std::vector<Plane> floor_through(double x, double width) {
  return {level(0, 0, 0, 6, 5), level(x, 5, 0, width, 0.1), level(0, 5.1, 0, 6, 3)};
}

std::vector<DoorOpening> openings(Plane wall, std::vector<Plane> others,
                                  const std::vector<Vector3d>& driven = {}) {
  others.push_back(std::move(wall));
  return semantics_of(others, driven).openings;
}

TEST(DoorOpenings, HaveJambsSillAndHead) {
  const auto found = openings(wall_with_gap(0.9), floor_through(2, 0.9));
  ASSERT_EQ(1u, found.size());
  EXPECT_EQ(7, found[0].plane);
  EXPECT_NEAR(0.0, (found[0].jambs[0] - Vector3d(2.0, 5, 0)).norm(), 0.051);
  EXPECT_NEAR(0.0, (found[0].jambs[1] - Vector3d(2.9, 5, 0)).norm(), 0.051);
  EXPECT_NEAR(0.0, found[0].sill_m, 1e-9);
  ASSERT_TRUE(found[0].head_m.has_value());
  EXPECT_NEAR(2.1, *found[0].head_m, 0.051);
  EXPECT_GT(found[0].confidence, 0.9);
}

TEST(DoorOpenings, AreAsWideAsADoor) {
  EXPECT_EQ(0u, openings(wall_with_gap(0.4), floor_through(2, 0.4)).size());
  EXPECT_EQ(1u, openings(wall_with_gap(2.0), floor_through(2, 2.0)).size());
  EXPECT_EQ(0u, openings(wall_with_gap(3.0), floor_through(2, 3.0)).size());
}

TEST(DoorOpenings, AreNoWindows) {
  EXPECT_EQ(0u, openings(wall_with_gap(0.9, 0.9), floor_through(2, 0.9)).size());
}

TEST(DoorOpenings, AreNotWhereFurnitureHidesTheWall) {
  EXPECT_EQ(0u, openings(wall_with_gap(0.9), floor_through(0, 0.0)).size());
}

TEST(DoorOpenings, WithoutALintelNeedARobotThatDroveThrough) {
  const Plane wall = wall_with_gap(0.9, -1.0, 3.0);
  EXPECT_EQ(0u, openings(wall, floor_through(2, 0.9)).size());
  const auto found = openings(wall, floor_through(2, 0.9), {Vector3d(2.5, 5.05, 0)});
  ASSERT_EQ(1u, found.size());
  EXPECT_FALSE(found[0].head_m.has_value());
}

TEST(DoorOpenings, MayLieBetweenTwoPlanesOfOneWall) {
  std::vector<Plane> others = floor_through(2, 2.0);
  others.push_back(upright(4, 5, 2, 0, 2.6, 8));
  EXPECT_EQ(1u, openings(upright(0, 5, 2, 0, 2.6, 7), others, {Vector3d(3, 5.05, 0)}).size());
}

TEST(DoorOpenings, HoldTheLeafThatHangsInThem) {
  std::vector<Plane> planes = floor_through(2, 0.9);
  planes.push_back(wall_with_gap(0.9));
  planes.push_back(rectangle({2.0, 5.0, 0}, {0, -0.85, 0}, {0, 0, 2.0}));  // open by 90 degrees
  EXPECT_EQ(Label::door_leaf, semantics_of(planes, {}).labels.back().label);
  planes.back() = rectangle({1.0, 5.0, 0}, {0, -0.85, 0}, {0, 0, 2.0});  // a cupboard's side
  EXPECT_EQ(Label::furniture, semantics_of(planes, {}).labels.back().label);
}

TEST(DoorOpenings, AreClosedByALeafThatIsAjar) {
  std::vector<Plane> planes = floor_through(0, 0.0);
  planes.push_back(wall_with_gap(0.9));
  EXPECT_EQ(0u, semantics_of(planes, {}).openings.size());
  planes.push_back(rectangle({2.0, 5.0, 0}, {0.85, -0.15, 0}, {0, 0, 2.0}));
  const Semantics semantics = semantics_of(planes, {});
  EXPECT_EQ(Label::door_leaf, semantics.labels.back().label);
  ASSERT_EQ(1u, semantics.openings.size());
  EXPECT_FALSE(semantics.openings[0].is_passable);
}

TEST(DoorOpenings, AreNotBesideTheSidesOfACupboard) {
  std::vector<Plane> planes = floor_through(0, 0.0);
  planes.push_back(wall_with_gap(0.9));
  planes.push_back(rectangle({2.0, 5.0, 0}, {0, -0.6, 0}, {0, 0, 2.0}));
  const Semantics semantics = semantics_of(planes, {});
  EXPECT_EQ(Label::furniture, semantics.labels.back().label);
  EXPECT_EQ(0u, semantics.openings.size());
}

TEST(DoorOpenings, HaveRevealsThatBelongToTheWall) {
  std::vector<Plane> planes = floor_through(2, 0.9);
  planes.push_back(wall_with_gap(0.9));
  planes.push_back(rectangle({2.0, 5.2, 0}, {0, -0.2, 0}, {0, 0, 2.1}));
  EXPECT_EQ(Label::wall, semantics_of(planes, {}).labels.back().label);
}

}  // namespace
}  // namespace ribbon_mapper
