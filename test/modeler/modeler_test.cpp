// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/modeler.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "test/modeler/plane_matchers.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Returns lines of the room, recorded without drift.
Lines tour_without_drift() {
  return drive(room(), {around_the_middle, to_and_fro, no_drift}, 0.0, 15.0);
}

TEST(Modeler, MakesOnePlaneOfEachFace) {
  const Modeler modeler = model_of(tour_without_drift());
  expect_one_for_each(room(), modeler.planes_as_built(), 0.3, 0.01);
  expect_one_for_each(room(), modeler.planes(), 0.3, 0.01);
  const ModelStatistics statistics = modeler.statistics();
  EXPECT_EQ(600u, statistics.lines);
  EXPECT_GT(statistics.ribbons, 1000u);
  EXPECT_EQ(0u, statistics.revision);
  EXPECT_GT(modeler.memory_bytes(), 1000u * sizeof(double));
}

TEST(Modeler, ReturnsConsistentPlanes) {
  for (const Plane& plane : model_of(tour_without_drift()).planes()) {
    EXPECT_NEAR(1.0, plane.normal.norm(), 1e-12);
    EXPECT_LT((plane.axis_u.cross(plane.axis_v) - plane.normal).norm(), 1e-9);
    EXPECT_NEAR(0.0, plane.normal.dot(plane.centroid) + plane.d_m, 1e-6);
    EXPECT_NEAR(0.0, plane.normal.dot(plane.origin) + plane.d_m, 1e-9);
    EXPECT_NEAR(plane.cells.size() * 0.05 * 0.05, plane.area_m2, 1e-9);
    EXPECT_GE(plane.outlines.at(0).outer.size(), 4u);
    const double wall_m2 = 6.0 * 5.0;  // area of the largest face
    EXPECT_GT(plane.area_m2, 0.3 * wall_m2);
    EXPECT_LT(plane.area_m2, wall_m2);
    for (int i = 0; i < 3; ++i) EXPECT_GT(plane.covariance(i, i), 0.0);
  }
}

/// Models a board of 1.2 m with strips of 9 cm next to it, which are too narrow for ribbons. The
/// robot drives up to it.
TEST(Modeler, IncludesUnassignedPointsSeenWhileDriving) {
  const auto board = [](double min_y, double max_y) {
    return plane(-Eigen::Vector3d::UnitX(), 3.0, {0, min_y, 0}, {9, max_y, 2.5});
  };
  const World world{board(-0.6, 0.6), board(0.66, 0.75), board(-0.75, -0.66)};
  const auto drive_up = [](double time_s) { return planar_pose(0.2 * time_s, 0.0, 0.0); };
  const auto planes = model_of(drive(world, {drive_up, to_and_fro, no_drift}, 0.0, 6.0)).planes();
  ASSERT_EQ(1u, planes.size());
  std::size_t on_strips = 0;
  for (const PlaneCell& cell : planes[0].cells) {
    on_strips += std::abs(cell_centre(planes[0], cell).y()) > 0.65;
  }
  EXPECT_GT(on_strips, 0.7 * 2 * (0.09 / 0.05) * (2.5 / 0.05));
}

/// Drives round after round in one room. The limit of ribbons is reached in the first round.
TEST(Modeler, StaysWithinItsMemory) {
  ModelerConfig config;
  config.observations.max_ribbons = 600;
  Modeler modeler(config);
  std::size_t max_bytes_in_first_half = 0;
  constexpr int kRounds = 12;
  for (int round = 0; round < kRounds; ++round) {
    for (Line line : tour_without_drift()) {
      line.beams.stamp += from_seconds(20.0 * round);
      const LineResult result = modeler.add_scan_line(line.beams, line.poses);
      ASSERT_TRUE(result == LineResult::modelled || result == LineResult::too_close ||
                  result == LineResult::waiting);
      ASSERT_LE(modeler.statistics().ribbons, 600u);
    }
    const std::size_t bytes = modeler.memory_bytes();
    if (round < kRounds / 2) max_bytes_in_first_half = std::max(max_bytes_in_first_half, bytes);
    EXPECT_LT(bytes, max_bytes_in_first_half * 5 / 4) << "round " << round;
    expect_one_for_each(room(), modeler.planes(), 0.3, 0.01);
  }
  EXPECT_GT(modeler.statistics().thinned, 600u);
  const auto trajectory = modeler.trajectory();
  EXPECT_LE(trajectory.size(), 600u);
  for (const Ribbon& ribbon : modeler.ribbons()) ASSERT_LT(ribbon.pose, trajectory.size());
}

/// Expects a corrected model of thinned ribbons to be as good as one of all ribbons.
TEST(Modeler, CanBeCorrectedAfterThinning) {
  ModelerConfig config;
  config.observations.max_ribbons = 600;
  Modeler modeler(config);
  const Motion motion{around_the_middle, to_and_fro, wandering_drift};
  const Lines lines = drive(room(), motion, 0.0, 15.0);
  for (const Line& line : lines) modeler.add_scan_line(line.beams, line.poses);
  ASSERT_LT(modeler.trajectory().size(), 550u);
  modeler.correct(true_trajectory(lines));
  expect_one_for_each(room(), modeler.planes(), 0.3, 0.01);
}

TEST(Modeler, IsEmptyAtFirst) {
  Modeler modeler{ModelerConfig{}};
  EXPECT_TRUE(modeler.planes_as_built().empty());
  EXPECT_TRUE(modeler.planes().empty());
  EXPECT_TRUE(modeler.trajectory().empty());
  EXPECT_EQ(0u, modeler.statistics().lines);
  modeler.memory_bytes();
}

TEST(Modeler, RefusesABadConfiguration) {
  ModelerConfig config;
  config.surface.cell_size_m = -1.0;
  EXPECT_THROW(Modeler{config}, std::invalid_argument);
}

TEST(Modeler, ReportsTheResultOfEachLine) {
  Modeler modeler{ModelerConfig{}};
  const Lines lines = tour_without_drift();
  const auto result_of = [&](Line line, const std::function<void(Line&)>& spoil) {
    spoil(line);
    return modeler.add_scan_line(line.beams, line.poses);
  };
  EXPECT_EQ(LineResult::waiting, result_of(lines[10], [](Line&) {}));
  EXPECT_EQ(LineResult::out_of_order, result_of(lines[10], [](Line&) {}));
  EXPECT_EQ(LineResult::out_of_order, result_of(lines[9], [](Line&) {}));
  EXPECT_EQ(LineResult::too_close,
            result_of(lines[10], [](Line& line) { line.beams.stamp += from_seconds(0.001); }));
  for (const float invalid : {kNan, kInf, -kInf, -1.0F, 0.0F, 1e9F}) {
    EXPECT_EQ(LineResult::no_returns,
              result_of(lines[11], [=](Line& line) { line.beams.ranges_m.assign(361, invalid); }));
  }
  EXPECT_EQ(LineResult::no_returns,
            result_of(lines[11], [](Line& line) { line.beams.ranges_m.clear(); }));
  EXPECT_EQ(LineResult::malformed,
            result_of(lines[11], [](Line& line) { line.beams.ranges_m.resize(1000, 2.0F); }));
  EXPECT_EQ(LineResult::malformed,
            result_of(lines[11], [](Line& line) { line.beams.angle_increment_rad = kNan; }));
  EXPECT_EQ(LineResult::malformed, result_of(lines[11], [](Line& line) {
              line.poses.T_map_base.translation().x() = kNan;
            }));
  EXPECT_EQ(LineResult::waiting, result_of(lines[11], [](Line&) {}));
  EXPECT_EQ(LineResult::modelled, result_of(lines[12], [](Line&) {}));
  EXPECT_EQ(16u, modeler.statistics().lines);
}

/// Beams that are fewer than ribbon.min_points make no ribbon.
TEST(Modeler, DoesNotCallALineWithoutRibbonsModelled) {
  Modeler modeler{ModelerConfig{}};
  std::size_t without = 0;
  for (Line line : tour_without_drift()) {
    for (std::size_t i = 4; i < line.beams.ranges_m.size(); ++i) line.beams.ranges_m[i] = kInf;
    const LineResult result = modeler.add_scan_line(line.beams, line.poses);
    EXPECT_NE(LineResult::modelled, result);
    without += result == LineResult::no_ribbons;
  }
  EXPECT_GT(without, 100u);
  EXPECT_EQ(0u, modeler.statistics().ribbons);
}

/// Leaves out another number of beams at both ends of each line and takes each line at another
/// step, as lasers do whose motor and sampling are not synchronised.
TEST(Modeler, TakesLinesOfAnyNumberOfBeams) {
  Modeler modeler{ModelerConfig{}};
  Lines lines;
  for (std::size_t beams = 351; beams <= 371; ++beams) {
    const double from_s = 0.7 * static_cast<double>(beams - 351);
    for (Line& line : drive(room(), {around_the_middle, to_and_fro, no_drift}, from_s,
                            from_s + 0.69, {beams, 0.005, 1})) {
      lines.push_back(std::move(line));
    }
  }
  std::size_t i = 0, modelled = 0;
  for (Line& line : lines) {
    LaserBeams& beams = line.beams;
    const std::size_t cut = ++i % 7;
    beams.ranges_m.erase(beams.ranges_m.begin(),
                         beams.ranges_m.begin() + static_cast<std::ptrdiff_t>(cut));
    beams.angle_min_rad += static_cast<double>(cut) * beams.angle_increment_rad;
    modelled += modeler.add_scan_line(beams, line.poses) == LineResult::modelled;
  }
  EXPECT_GT(modelled, lines.size() * 3 / 4);
  expect_one_for_each(room(), modeler.planes(), 0.3, 0.01);
}

TEST(Modeler, HasANameForEachResult) {
  EXPECT_STREQ("modelled", to_string(LineResult::modelled));
  EXPECT_STREQ("waiting for neighbours", to_string(LineResult::waiting));
  EXPECT_STREQ("no ribbons", to_string(LineResult::no_ribbons));
  EXPECT_STREQ("too close", to_string(LineResult::too_close));
  EXPECT_STREQ("no returns", to_string(LineResult::no_returns));
  EXPECT_STREQ("malformed", to_string(LineResult::malformed));
  EXPECT_STREQ("out of order", to_string(LineResult::out_of_order));
}

TEST(Modeler, IsUnaffectedByBadLines) {
  const Lines lines = tour_without_drift();
  Modeler modeler{ModelerConfig{}};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    modeler.add_scan_line(lines[i].beams, lines[i].poses);
    Line bad = lines[i];
    bad.beams.stamp += from_seconds(0.001);
    if (i % 5 == 0) bad.beams.ranges_m.assign(361, kNan);
    if (i % 5 == 1) bad.beams.ranges_m.clear();
    if (i % 5 == 2) bad.beams.ranges_m.resize(1000, 1.0F);
    if (i % 5 == 3) bad.beams.stamp -= from_seconds(3.0);
    if (i % 5 == 4) bad.poses.T_odom_base_last.linear()(0, 1) = kInf;
    EXPECT_NE(LineResult::modelled, modeler.add_scan_line(bad.beams, bad.poses));
  }
  EXPECT_EQ(bytes_of(model_of(lines).planes()), bytes_of(modeler.planes()));
}

TEST(Modeler, LosesNoPlaneToInvalidRanges) {
  Lines lines = tour_without_drift();
  for (Line& line : lines) {
    for (std::size_t i = 0; i < 361; i += 40) line.beams.ranges_m[i] = i % 80 ? kNan : kInf;
  }
  expect_one_for_each(room(), model_of(lines).planes(), 0.3, 0.01);
}

TEST(Modeler, AcceptsLinesOfAnotherLength) {
  Modeler modeler{ModelerConfig{}};
  const Motion motion{around_the_middle, to_and_fro, no_drift};
  for (const Line& line : drive(room(), motion, 0.0, 7.0)) {
    modeler.add_scan_line(line.beams, line.poses);
  }
  for (const Line& line : drive(room(), motion, 7.0, 15.0, {541, 0.005, 2})) {
    EXPECT_NE(LineResult::malformed, modeler.add_scan_line(line.beams, line.poses));
  }
  expect_one_for_each(room(), modeler.planes(), 0.3, 0.01);
}

TEST(Modeler, IsDeterministic) {
  const Lines lines = drive(room(), {around_the_middle, to_and_fro, wandering_drift}, 0.0, 15.0);
  Modeler one = model_of(lines), other = model_of(lines);
  EXPECT_EQ(bytes_of(one.planes_as_built()), bytes_of(other.planes_as_built()));
  one.planes();  // a query changes nothing
  one.correct(true_trajectory(lines));
  other.correct(true_trajectory(lines));
  EXPECT_EQ(bytes_of(one.planes_as_built()), bytes_of(other.planes_as_built()));
  EXPECT_EQ(bytes_of(one.planes()), bytes_of(other.planes()));
}

TEST(Modeler, IsEmptyAfterReset) {
  const Lines lines = tour_without_drift();
  Modeler modeler = model_of(lines);
  const std::string before = bytes_of(modeler.planes());
  modeler.correct(true_trajectory(lines, 50));
  modeler.reset();
  EXPECT_TRUE(modeler.planes_as_built().empty());
  EXPECT_TRUE(modeler.trajectory().empty());
  EXPECT_EQ(0u, modeler.statistics().lines);
  EXPECT_EQ(0u, modeler.statistics().ribbons);
  EXPECT_EQ(0u, modeler.statistics().revision);
  for (const Line& line : lines) modeler.add_scan_line(line.beams, line.poses);  // older stamps
  EXPECT_EQ(before, bytes_of(modeler.planes()));
}

}  // namespace
}  // namespace ribbon_mapper
