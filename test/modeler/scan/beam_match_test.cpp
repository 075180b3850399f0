// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/beam_match.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ribbon_mapper {
namespace {

/// Returns a line of these bearings, all of them with a return on a circle.
ScanLine line_of(std::size_t count, double first_rad, double step_rad) {
  LaserBeams beams;
  beams.angle_min_rad = first_rad;
  beams.angle_increment_rad = step_rad;
  beams.range_max_m = 30.0;
  beams.ranges_m.assign(count, 4.0F);
  ScanConfig config;
  config.body_half_size_m = 0.0;
  ScanLine line;
  place_beams(beams, {}, config, line);
  return line;
}

double bearing_rad(const ScanLine& line, std::int64_t beam) {
  return line.first_angle_rad + static_cast<double>(beam) * line.angle_increment_rad;
}

TEST(BeamMatch, IsByIndexForTheSameBearings) {
  const ScanLine line = line_of(361, -1.5, 0.01), other = line_of(361, -1.5, 0.01);
  const BeamMatch match(line, other);
  for (std::size_t beam = 0; beam < 361; ++beam) {
    EXPECT_EQ(static_cast<std::int64_t>(beam), match.nearest(beam));
    EXPECT_EQ(other.directions[beam], match.direction(beam));
  }
  EXPECT_EQ(other.moments(20, 70).weight(), match.moments(20, 70).weight());
}

TEST(BeamMatch, FindsTheNearestBearing) {
  const ScanLine line = line_of(300, -1.5, 0.01);
  for (const ScanLine& other :
       {line_of(310, -1.5, 3.0 / 310.0), line_of(150, -1.5, 0.02), line_of(600, -1.49, 0.005)}) {
    const BeamMatch match(line, other);
    for (std::size_t beam = 10; beam < 290; ++beam) {
      const double bearing = bearing_rad(line, static_cast<std::int64_t>(beam));
      EXPECT_LE(std::abs(bearing_rad(other, match.nearest(beam)) - bearing),
                0.5 * other.angle_increment_rad + 1e-9);
      EXPECT_LT((match.direction(beam) - line.directions[beam]).norm(), 1e-4);
      EXPECT_TRUE(match.has_return(beam));
    }
  }
}

TEST(BeamMatch, CountsEachBeamOfTheOtherLineOnce) {
  const ScanLine line = line_of(300, -1.5, 0.01), other = line_of(317, -1.5, 3.0 / 317.0);
  const BeamMatch match(line, other);
  double sum = 0.0;
  for (std::size_t beam = 0; beam < 300; beam += 20) sum += match.moments(beam, beam + 20).weight();
  EXPECT_EQ(317.0, sum);
}

TEST(BeamMatch, HasNoReturnsOutsideOfTheOtherLine) {
  const ScanLine line = line_of(300, -1.5, 0.01), other = line_of(100, -0.5, 0.01);
  const BeamMatch match(line, other);
  EXPECT_FALSE(match.has_return(90));
  EXPECT_TRUE(match.has_return(110));
  EXPECT_FALSE(match.has_return(210));
  EXPECT_EQ(0.0, match.moments(0, 90).weight());
  EXPECT_EQ(100.0, match.moments(0, 300).weight());
  EXPECT_EQ(100, match.first_of_segment(150));
  EXPECT_EQ(200, match.end_of_segment(150));
}

}  // namespace
}  // namespace ribbon_mapper
