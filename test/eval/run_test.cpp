// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/experiment/run.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "sim/robot/hokuyo.hpp"

namespace ribbon_mapper::eval {
namespace {

TEST(Run, BeamsAreCountedAboutStraightAhead) {
  for (const int count : {3, 380, 381, 720, 1040, 1080, 1081}) {
    RunOptions run;
    run.beams = count;
    const sim::HokuyoConfig config = tour_config(run).hokuyo;
    const sim::Hokuyo hokuyo(config, 1);
    EXPECT_EQ(hokuyo.beam_count(), count);
    EXPECT_NEAR(hokuyo.angle_min_rad(), -(count / 2) * config.angle_increment_rad, 1e-12);
  }
}

TEST(Run, TheRateIsThatOfTheScans) {
  RunOptions run;
  run.rate_hz = 20.0;
  EXPECT_EQ(sim::Hokuyo(tour_config(run).hokuyo, 1).period(), from_seconds(0.05));
}

TEST(Run, TheSpeedScalesTheRoute) {
  RunOptions run;
  run.world = "test/ros/room.sdf";
  const sim::Route usual = load_route(run);
  run.speed_m_s = 0.25;
  const sim::Route slow = load_route(run);
  EXPECT_EQ(usual.speed_m_s(), 0.5);
  EXPECT_EQ(slow.speed_m_s(), 0.25);
  EXPECT_EQ(slow.length_m(), usual.length_m());
  EXPECT_GT(slow.duration(), usual.duration());
  EXPECT_EQ(slow.velocity(from_seconds(3.0)).turn_rad_s, 0.0) << "the first leg is straight";
}

TEST(Run, OdometryFaultsReachTheTour) {
  RunOptions run;
  EXPECT_TRUE(tour_config(run).localisation.faults.slips.empty());
  run.odometry_faults = "slip=30:20";
  EXPECT_EQ(tour_config(run).localisation.faults.slips.size(), 1U);
}

TEST(Run, DeskewIsThePresetsUnlessGiven) {
  RunOptions run;
  EXPECT_TRUE(modeler_config(run).scan.deskew);
  run.deskew = false;
  EXPECT_FALSE(modeler_config(run).scan.deskew);
}

/// The leaf of a door that stands ajar by a few degrees is a plane beside the wall.
TEST(Run, FindsADoorAjarBesideItsWall) {
  for (const std::string world : {"door_5_1", "door_7_-1"}) {
    RunOptions run;
    run.world = "test/data/field/" + world + ".world";
    run.drift = 0.0;
    const Results results = make_run(run, [](const Progress&) {});
    std::vector<double> areas_m2;
    for (const Plane& plane : results.models.corrected) {
      if (plane.normal.y() < -0.9 && plane.d_m < 2.5) areas_m2.push_back(plane.area_m2);
    }
    std::sort(areas_m2.begin(), areas_m2.end());
    ASSERT_EQ(2U, areas_m2.size()) << world;
    EXPECT_NEAR(1.90, areas_m2[0], 0.1) << world;
    EXPECT_NEAR(9.45, areas_m2[1], 0.5) << world;
  }
}

TEST(Route, RestsBeforeItStarts) {
  const std::vector<Eigen::Vector2d> way{{0.0, 0.0}, {1.0, 0.0}};
  const sim::Route at_once(0.5, 1.0, way), later(0.5, 1.0, way, 4.0);
  EXPECT_EQ(later.duration(), at_once.duration() + from_seconds(4.0));
  for (const double time_s : {0.0, 2.0, 4.0}) {
    EXPECT_EQ(later.T_map_base(from_seconds(time_s)).translation().x(), 0.0);
    EXPECT_EQ(later.velocity(from_seconds(time_s)).forward_m_s, 0.0);
  }
  EXPECT_NEAR(later.T_map_base(from_seconds(5.5)).translation().x(),
              at_once.T_map_base(from_seconds(1.5)).translation().x(), 1e-9);
  EXPECT_THROW(sim::Route(0.5, 1.0, way, -1.0), std::invalid_argument);
}

}  // namespace
}  // namespace ribbon_mapper::eval
