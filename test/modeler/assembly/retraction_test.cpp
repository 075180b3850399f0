// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/retraction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/modeler/mini_world.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;

/// A screen of 1 x 2 m that stands 1.5 m before the robot, in the plane x = 1.5.
World room_with_screen() {
  World world = room();
  world.push_back(plane(-Eigen::Vector3d::UnitX(), 1.5, {1.45, -0.5, 0.0}, {1.55, 0.5, 2.0}));
  return world;
}

/// A wall in the plane x = 1.5 with a doorway of 0.9 x 2 m, which a leaf may close.
World room_with_doorway(bool is_closed) {
  World world = room();
  const auto part = [&](double y0, double y1, double z0, double z1) {
    world.push_back(plane(-Eigen::Vector3d::UnitX(), 1.5, {1.45, y0, z0}, {1.55, y1, z1}));
  };
  part(-2.5, -0.45, 0.0, 2.5), part(0.45, 2.5, 0.0, 2.5), part(-0.45, 0.45, 2.0, 2.5);
  if (is_closed) part(-0.45, 0.45, 0.0, 2.0);
  return world;
}

/// Returns the planes of a robot that sees one world for 12 s and then another, corrected.
std::vector<Plane> planes_of(const World& before, const World& after, int passed_lines,
                             bool is_corrected = true) {
  const Motion motion = tilting_in_place();  // four sweeps see each cell several times
  Lines lines = drive(before, motion, 0.0, 12.0);
  for (const Line& line : drive(after, motion, 12.0, 24.0)) lines.push_back(line);
  ModelerConfig config;
  config.assembly.passed_lines = passed_lines;
  Modeler modeler = model_of(lines, config);
  if (is_corrected) modeler.correct(true_trajectory(lines));
  return modeler.planes();
}

/// Returns the area of the planes near x = 1.5 that face the robot.
double area_at_screen_m2(const std::vector<Plane>& planes) {
  double area_m2 = 0.0;
  for (const Plane& plane : planes) {
    if (plane.normal.x() < -0.99 && std::abs(plane.d_m - 1.5) < 0.1) area_m2 += plane.area_m2;
  }
  return area_m2;
}

double area_m2(const std::vector<Plane>& planes) {
  double sum_m2 = 0.0;
  for (const Plane& plane : planes) sum_m2 += plane.area_m2;
  return sum_m2;
}

TEST(Retraction, WhatWasTakenAwayIsNoPlane) {
  const auto all = planes_of(room_with_screen(), room(), 0);
  const auto planes = planes_of(room_with_screen(), room(), 3);
  EXPECT_GT(area_at_screen_m2(all), 1.6);
  EXPECT_EQ(area_at_screen_m2(planes), 0.0);
  EXPECT_DOUBLE_EQ(area_m2(planes), area_m2(all) - area_at_screen_m2(all))
      << "the room stays whole";
}

TEST(Retraction, WhatWasPutThereStays) {
  const auto planes = planes_of(room(), room_with_screen(), 3);
  EXPECT_GT(area_at_screen_m2(planes), 1.6);
  EXPECT_DOUBLE_EQ(area_m2(planes), area_m2(planes_of(room(), room_with_screen(), 0)));
}

TEST(Retraction, WhatIsThereStays) {
  for (const World& world : {room_with_screen(), room_with_doorway(false)}) {
    EXPECT_DOUBLE_EQ(area_m2(planes_of(world, world, 3)), area_m2(planes_of(world, world, 0)));
  }
}

TEST(Retraction, ADoorThatOpensLeavesItsWall) {
  const auto all = planes_of(room_with_doorway(true), room_with_doorway(false), 0);
  const auto planes = planes_of(room_with_doorway(true), room_with_doorway(false), 3);
  const double gone_m2 = area_at_screen_m2(all) - area_at_screen_m2(planes);
  EXPECT_GT(gone_m2, 0.75 * 0.9 * 2.0);
  EXPECT_LT(gone_m2, 1.05 * 0.9 * 2.0);
  EXPECT_EQ(planes.size(), all.size());
  for (const Plane& plane : planes) EXPECT_FALSE(plane.outlines.empty());
}

TEST(Retraction, NothingGoesBeforeACorrection) {
  EXPECT_GT(area_at_screen_m2(planes_of(room_with_screen(), room(), 3, false)), 1.6);
}

}  // namespace
}  // namespace ribbon_mapper
