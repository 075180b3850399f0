// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "modeler/semantics/semantics.hpp"
#include "test/modeler/semantics/rectangles.hpp"

namespace ribbon_mapper {
namespace {

using namespace rectangles;
using Eigen::Vector3d;

/// Returns a floor of 6 x 5 m.
Plane room_floor() { return level(0, 0, 0, 6, 5); }

/// Returns the decision about a plane above room_floor() and among `others`.
Decision decision_on(const Plane& plane, std::vector<Plane> others = {},
                     const std::vector<Vector3d>& driven = {}) {
  others.insert(others.begin(), {plane, room_floor()});
  return semantics_of(others, driven).labels.at(0);
}

Label label_of(const Plane& plane, const std::vector<Plane>& others = {},
               const std::vector<Vector3d>& driven = {}) {
  return decision_on(plane, others, driven).label;
}

Plane ceiling() { return level_down(0, 0, 2.6, 6, 5); }

TEST(Labels, HaveTextsThatAreRead) {
  for (const Label label : kLabels) EXPECT_EQ(label, label_from(to_string(label)));
  EXPECT_EQ(std::nullopt, label_from("door"));
}

TEST(Labels, AFloorIsTheLargestLevelPlaneIfNothingIsKnownOfTheRobot) {
  EXPECT_EQ(Label::floor, semantics_of({room_floor()}, {}).labels.at(0).label);
  EXPECT_EQ(Label::floor, label_of(level(7, 0, 0.02, 1, 1)));  // of the next room
}

TEST(Labels, AFloorIsWhatTheRobotHasDrivenOn) {
  const Plane platform = level(2, 2, 0.3, 2, 2);
  EXPECT_EQ(Label::top, label_of(platform));
  const std::vector<Vector3d> driven(3, Vector3d(3, 3, 0.3));
  EXPECT_EQ(Label::floor, label_of(platform, {}, driven));
  EXPECT_GT(decision_on(platform, {}, driven).confidence, 0.99);
}

TEST(Labels, AFloorBelowTheMainFloorIsNoTable) {
  EXPECT_EQ(Label::floor, label_of(level(7, 0, -0.5, 2, 2)));
}

TEST(Labels, ATopIsLevelAndAboveTheFloor) {
  for (const double height_m : {0.15, 0.45, 0.74, 1.2}) {
    EXPECT_EQ(Label::top, label_of(level(1, 1, height_m, 1, 1))) << height_m;
  }
}

TEST(Labels, ACeilingIsOverHead) {
  EXPECT_EQ(Label::ceiling, label_of(ceiling()));
  EXPECT_EQ(Label::furniture, label_of(level_down(1, 1, 0.7, 1, 1)));  // under a table
}

TEST(Labels, ARampBeginsAtTheFloor) {
  const Vector3d rising(2, 0, 0.2);
  EXPECT_EQ(Label::slope, label_of(rectangle({1, 3, 0}, {0, -1, 0}, rising)));
  EXPECT_EQ(Label::furniture, label_of(rectangle({1, 3, 0.7}, {0, -1, 0}, rising)));  // a desk
}

TEST(Labels, ARampIsDrivenOnEvenIfItsFootIsHidden) {
  const Plane ramp = rectangle({1, 3, 0.3}, {0, -1, 0}, {2, 0, 0.2});
  EXPECT_EQ(Label::slope, label_of(ramp, {}, std::vector<Vector3d>(3, Vector3d(2, 2.5, 0.4))));
}

TEST(Labels, ARoofIsASlope) {
  EXPECT_EQ(Label::slope, label_of(rectangle({0, 0, 1}, {0, 5, 0}, {2.5, 0, 2.5})));
}

TEST(Labels, AWallReachesTheCeiling) {
  EXPECT_EQ(Label::wall, label_of(upright(0, 5, 6, 0, 2.6), {ceiling()}));
  EXPECT_EQ(Label::wall, label_of(upright(0, 5, 6, 0, 2.4), {ceiling()}));    // not quite seen
  EXPECT_EQ(Label::wall, label_of(upright(2, 2, 0.4, 0, 2.6), {ceiling()}));  // a pillar
}

TEST(Labels, AWallUnderARoofMayBeLow) {
  const Plane knee = upright(0, 5, 6, 0, 1);
  EXPECT_EQ(Label::furniture, label_of(knee));
  const Plane roof = rectangle({0, 5, 1.0}, {6, 0, 0}, {0, -5, 2.5});
  EXPECT_EQ(Label::wall, label_of(knee, {roof}));
}

TEST(Labels, AWallWithoutACeilingIsHigherThanADoor) {
  EXPECT_EQ(Label::wall, label_of(upright(0, 5, 6, 0, 2.5)));
  EXPECT_EQ(Label::wall, label_of(upright(0, 5, 6, 0, 2.05)));
  EXPECT_EQ(Label::furniture, label_of(upright(1, 4, 2, 0, 1.8)));    // a screen
  EXPECT_EQ(Label::furniture, label_of(upright(1, 4, 0.6, 0, 2.1)));  // the side of a cupboard
}

TEST(Labels, AWallThatLeansIsAWall) {
  EXPECT_EQ(Label::wall, label_of(rectangle({0, 5, 0}, {6, 0, 0}, {0, 0.5, 2.5})));
}

TEST(Labels, FurnitureHasAWallBehindThatRisesHigher) {
  const Plane front = upright(1, 4.4, 2, 0, 2.2);
  EXPECT_EQ(Label::wall, label_of(front));
  EXPECT_EQ(Label::furniture, label_of(front, {upright(0, 5, 6, 0, 2.6)}));
  EXPECT_EQ(Label::wall, label_of(front, {upright(0, 7, 6, 0, 2.6)}));      // of the next room
  EXPECT_EQ(Label::wall, label_of(front, {upright(0, 5, 6, 0, 2.25)}));     // no higher
  EXPECT_EQ(Label::wall, label_of(front, {upright(3.5, 5, 2.5, 0, 2.6)}));  // beside it
}

TEST(Labels, APlaneWithoutCellsIsNothing) {
  Plane plane;
  const Semantics semantics = semantics_of({plane}, {});
  EXPECT_EQ(0.0, semantics.labels.at(0).confidence);
  EXPECT_TRUE(semantics_of({}, {}).labels.empty());
}

TEST(Labels, ConfidenceIsHalfAtALimitAndGrowsAway) {
  const double limit_m = LabelConfig{}.wall_height_m;
  const auto at = [](double top_m) { return decision_on(upright(0, 5, 6, 0, top_m)).confidence; };
  EXPECT_NEAR(0.5, at(std::round(limit_m / 0.05) * 0.05), 0.2);
  EXPECT_GT(at(2.15), at(2.05));
  EXPECT_GT(at(1.2), at(1.75));
  EXPECT_GT(at(1.2), 0.99);
}

TEST(Labels, ConfidenceKnowsHowWellATiltIsKnown) {
  Plane table = level(1, 1, 0.74, 1, 1);
  const double sure = decision_on(table).confidence;
  table.covariance(0, 0) = 0.05 * 0.05;
  EXPECT_LT(decision_on(table).confidence, sure);
}

}  // namespace
}  // namespace ribbon_mapper
