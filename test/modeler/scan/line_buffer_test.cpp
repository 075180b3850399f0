// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/line_buffer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "test/modeler/mini_world.hpp"

namespace ribbon_mapper {
namespace {

/// Returns a line whose beams all have the same range.
ScanLine line_at(const Pose& T_odom_base, double tilt_rad, double range_m = 4.0,
                 std::size_t count = 181) {
  LaserBeams beams;
  beams.angle_min_rad = -M_PI_2;
  beams.angle_increment_rad = M_PI / (count - 1.0);
  beams.range_max_m = 30.0;
  beams.ranges_m.assign(count, static_cast<float>(range_m));
  const Pose tilt = mini_world::T_base_laser(tilt_rad);
  ScanLine line;
  place_beams(beams, {T_odom_base, T_odom_base, tilt, tilt, Pose::Identity()}, {}, line);
  return line;
}

constexpr double kTiltStep_rad = 0.01;  // 40 mm at 4 m

/// Adds a line that is tilted further with each second.
void push(LineBuffer& buffer, int second, std::size_t count = 181) {
  buffer.incoming() = line_at(Pose::Identity(), kTiltStep_rad * second, 4.0, count);
  buffer.incoming().stamp = from_seconds(second);
  buffer.push();
}

double seconds_of(const ScanLine& line) { return to_seconds(line.stamp); }

TEST(LineBuffer, ReturnsEachLineWithItsNeighbours) {
  LineBuffer buffer(0.0);
  EXPECT_EQ(nullptr, buffer.newest_line());
  for (int second = 1; second <= 60; ++second) {
    push(buffer, second);
    EXPECT_EQ(second, seconds_of(*buffer.newest_line()));
    const auto lines = buffer.next_three_lines();
    ASSERT_EQ(second >= 3, lines.has_value());
    if (!lines) continue;
    EXPECT_EQ(second - 2, seconds_of(lines->previous));
    EXPECT_EQ(second - 1, seconds_of(lines->middle));
    EXPECT_EQ(second, seconds_of(lines->next));
    EXPECT_FALSE(buffer.next_three_lines()) << "each line is the middle line once";
  }
}

TEST(LineBuffer, SkipsLinesWhereTheyAreDense) {
  const double step_m =
      base_line_m(line_at(Pose::Identity(), 0.0), line_at(Pose::Identity(), kTiltStep_rad));
  LineBuffer buffer(2.5 * step_m);
  for (int second = 1; second <= 60; ++second) {
    push(buffer, second);
    const auto lines = buffer.next_three_lines();
    ASSERT_EQ(second >= 7, lines.has_value());
    if (!lines) continue;
    EXPECT_EQ(second - 6, seconds_of(lines->previous));
    EXPECT_EQ(second - 3, seconds_of(lines->middle));
    EXPECT_EQ(second, seconds_of(lines->next));
  }
}

TEST(LineBuffer, IgnoresALineThatIsNotPushed) {
  LineBuffer buffer(0.0);
  for (int second = 1; second <= 3; ++second) push(buffer, second);
  const auto lines = buffer.next_three_lines();
  ASSERT_TRUE(lines);
  buffer.incoming() = line_at(Pose::Identity(), 0.3, 9.0, 50);
  EXPECT_EQ(1, seconds_of(lines->previous));
  EXPECT_EQ(3, seconds_of(lines->next));
}

TEST(LineBuffer, PairsLinesOfAnotherLength) {
  LineBuffer buffer(0.0);
  for (int second = 1; second <= 3; ++second) push(buffer, second);
  EXPECT_TRUE(buffer.next_three_lines());
  push(buffer, 4, 91);
  const auto lines = buffer.next_three_lines();
  ASSERT_TRUE(lines);
  EXPECT_EQ(91u, lines->next.size());
  buffer.clear();
  EXPECT_FALSE(buffer.next_three_lines());
  EXPECT_EQ(nullptr, buffer.newest_line());
}

TEST(LineBuffer, StartsAgainWithLinesThatTurnTheOtherWay) {
  LineBuffer buffer(0.0);
  for (int second = 1; second <= 2; ++second) push(buffer, second);
  buffer.incoming() = line_at(Pose::Identity(), 3 * kTiltStep_rad);
  buffer.incoming().angle_increment_rad *= -1.0;
  buffer.push();
  EXPECT_FALSE(buffer.next_three_lines());
}

TEST(BaseLine, OfATiltIsRangeTimesStepAtTheMedianBeam) {
  // A beam at an azimuth a from the normal of the tilt axis moves by cos(a). The median azimuth of
  // -90 .. 90 degrees is 45 degrees. The tolerance allows for samples that are not symmetric.
  const double step_rad = 0.01;
  for (const double tilt_rad : {-0.5, 0.0, 0.8}) {
    const double base_line = base_line_m(line_at(Pose::Identity(), tilt_rad),
                                         line_at(Pose::Identity(), tilt_rad + step_rad));
    EXPECT_NEAR(4.0 * std::sin(step_rad) * M_SQRT1_2, base_line, 0.1 * 4.0 * step_rad);
  }
}

TEST(BaseLine, OfAMotionAcrossTheLineIsThatMotion) {
  const Pose up = Pose(Eigen::Translation3d(0.0, 0.0, 0.03));
  EXPECT_NEAR(0.03, base_line_m(line_at(Pose::Identity(), 0.0), line_at(up, 0.0)), 1e-6);
  EXPECT_NEAR(0.03 * std::cos(0.5), base_line_m(line_at(Pose::Identity(), 0.5), line_at(up, 0.5)),
              1e-6);
}

TEST(BaseLine, IsZeroForAMotionAlongTheLine) {
  const ScanLine before = line_at(Pose::Identity(), 0.0);
  EXPECT_NEAR(0.0, base_line_m(before, before), 1e-12);
  EXPECT_NEAR(0.0, base_line_m(before, line_at(planar_pose(0.2, -0.1, 0.1), 0.0)), 1e-9);
}

TEST(BaseLine, WithoutCommonReturns) {
  const ScanLine line = line_at(Pose::Identity(), 0.0);
  EXPECT_EQ(0.0, base_line_m(line, line_at(Pose::Identity(), 0.1, -1.0)));
  ScanLine behind = line;
  behind.first_angle_rad += M_PI + 0.1;
  EXPECT_TRUE(std::isinf(base_line_m(line, behind)));
  ScanLine reversed = line;
  reversed.angle_increment_rad *= -1.0;
  EXPECT_TRUE(std::isinf(base_line_m(line, reversed)));
}

TEST(BaseLine, MatchesBeamsByTheirBearing) {
  const ScanLine before = line_at(Pose::Identity(), 0.0);
  const double expected = base_line_m(before, line_at(Pose::Identity(), 0.01));
  for (const std::size_t count : {91u, 150u, 178u, 200u, 361u}) {
    EXPECT_NEAR(expected, base_line_m(before, line_at(Pose::Identity(), 0.01, 4.0, count)),
                0.1 * expected)
        << count << " beams";
  }
}

TEST(BaseLine, UsesTheWholeLine) {
  // Returns in the last quarter only, for several numbers of beams.
  for (const std::size_t count : {33u, 63u, 95u, 187u, 361u, 1040u}) {
    ScanLine before = line_at(Pose::Identity(), 0.0, 1.0, count);
    ScanLine after = line_at(Pose::Identity(), 0.01, 1.0, count);
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_last_quarter = 4 * i >= 3 * count;
      if (!is_last_quarter) after.ranges_m[i] = 0.0F;
    }
    EXPECT_GT(base_line_m(before, after), 0.0) << count << " beams";
  }
}

}  // namespace
}  // namespace ribbon_mapper
