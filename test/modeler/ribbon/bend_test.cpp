// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/bend.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "modeler/geometry/angles.hpp"
#include "modeler/ribbon/ribbon_extraction.hpp"
#include "test/modeler/ribbon/three_lines.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;

constexpr double kWall_m = 3.0, kLeaf_m = 0.9;

/// Returns a wall 2 m in front of the robot, on its right, and the leaf of a door beyond its left
/// end that is turned by an angle.
World wall_and_leaf(double angle_deg) {
  const double angle = angle_deg * kDegree, far = 10.0;
  const Eigen::Vector3d normal(-std::cos(angle), -std::sin(angle), 0.0);
  return {plane(-Eigen::Vector3d::UnitX(), 2.0, {0.0, -kWall_m, -far}, {far, 0.0, far}),
          plane(normal, 2.0 * std::cos(angle), {0.0, 0.0, -far},
                {far, kLeaf_m * std::cos(angle), far})};
}

LineTriple lines_of(const World& world, unsigned seed) {
  return three_lines(world, tilting(0.8), 0.0, {361, 0.01, seed});
}

/// Returns the beams with returns.
BeamRange seen(const ScanLine& line) {
  BeamRange beams{0, line.size()};
  while (!line.has_return(beams.begin)) ++beams.begin;
  while (!line.has_return(beams.end - 1)) --beams.end;
  return beams;
}

std::optional<std::size_t> bend_of(const World& world, unsigned seed) {
  const ScanLine line = lines_of(world, seed).middle;
  return find_bend(line, seen(line), ScanConfig{}, RibbonConfig{});
}

TEST(Bend, IsFoundAtTheHingeOfADoorThatStandsAjar) {
  for (const double angle_deg : {-10.0, -5.0, -3.0, 3.0, 5.0, 10.0}) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const World world = wall_and_leaf(angle_deg);
      const auto bend = bend_of(world, seed);
      ASSERT_TRUE(bend) << angle_deg << " degrees, seed " << seed;
      const double y_m = lines_of(world, seed).middle.points[*bend].y();
      EXPECT_NEAR(0.0, y_m, 0.9 / std::abs(angle_deg)) << angle_deg << " degrees, seed " << seed;
    }
  }
}

TEST(Bend, IsNotFoundOnAWall) {
  int found = 0;
  for (unsigned seed = 1; seed <= 500; ++seed) found += bend_of(wall_and_leaf(0.0), seed) ? 1 : 0;
  EXPECT_LE(found, 1);  // four standard errors, at about ten independent places
}

/// The association takes such a leaf for the wall.
TEST(Bend, IsNotFoundBelowTheAngleOfTheConfiguration) {
  int found = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) found += bend_of(wall_and_leaf(0.5), seed) ? 1 : 0;
  EXPECT_LE(found, 1);
}

TEST(Bend, NeedsPointsOnBothSides) {
  const ScanLine line = lines_of(wall_and_leaf(10.0), 1).middle;
  const BeamRange beams = seen(line);
  for (std::size_t size = 1; size < 12; ++size) {
    EXPECT_FALSE(find_bend(line, {beams.begin, beams.begin + size}, ScanConfig{}, RibbonConfig{}))
        << size;
  }
}

TEST(RibbonExtraction, DividesRibbonsAtABend) {
  for (const double angle_deg : {-5.0, 3.0, 5.0}) {
    const LineTriple lines = lines_of(wall_and_leaf(angle_deg), 1);
    RibbonExtraction extraction(ScanConfig{}, RibbonConfig{});
    const std::vector<Ribbon>& ribbons = extraction.extract(lines).ribbons;
    ASSERT_EQ(2U, ribbons.size()) << angle_deg;
    EXPECT_NEAR(kWall_m, ribbons[0].length_m, 0.35);
    EXPECT_NEAR(kLeaf_m, ribbons[1].length_m, 0.35);
    const double cosine = ribbons[0].along.dot(ribbons[1].along);
    EXPECT_NEAR(std::abs(angle_deg), std::acos(std::min(1.0, cosine)) / kDegree, 1.0);
    EXPECT_EQ(ribbons[0].last_beam + 1, ribbons[1].first_beam);
  }
}

}  // namespace
}  // namespace ribbon_mapper
