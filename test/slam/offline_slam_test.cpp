// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "modeler/io/tum.hpp"
#include "slam/ros/slam_run.hpp"
#include "test/bag/wall_bag.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper::slam {
namespace {

using testing::HasSubstr;

/// A robot that stands before a wall; its laser does not tilt.
class OfflineSlam : public testing::Test {
 protected:
  SlamRun run() {
    const auto bag = directory_.path() / "wall.bag";
    wall_.write(bag);
    const std::string name = bag.string();
    const char* const arguments[] = {"offline_slam", "--bag", name.c_str()};
    ros::Time::init();
    const auto options = parse_slam_options(3, arguments);
    return run_slam(std::get<SlamOptions>(options), [](const Progress&) {});
  }

  std::string error() {
    try {
      run();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }

  const TemporaryDirectory directory_;
  WallBag wall_ = [] {
    WallBag wall;
    wall.tilt_rad = 0.0;
    return wall;
  }();
};

TEST_F(OfflineSlam, AStandingRobotStands) {
  const SlamRun result = run();
  ASSERT_EQ(result.result.trajectory.size(), 200U);
  for (const StampedPlanarPose& pose : result.result.trajectory) {
    EXPECT_NEAR(pose.T_map_base.x_m, 0.0, 0.01) << "towards the wall";
    EXPECT_NEAR(pose.T_map_base.yaw_rad, 0.0, 0.01);
    // nothing is seen of the way along a lone wall: only the last prior holds
    EXPECT_NEAR(pose.T_map_base.y_m, 0.0, FinalMatchConfig().prior_m);
  }
  EXPECT_EQ(result.summary.keyframes, 1U);
  EXPECT_GT(result.points.size(), 10U);
}

TEST_F(OfflineSlam, WritesOneSetOfFilesThatNameTheirRun) {
  const auto folder = directory_.path() / "results";
  write_slam(run(), folder, false);
  EXPECT_EQ(read_tum(folder / "trajectory.tum").size(), 200U);
  const auto summary = nlohmann::json::parse(content_of(folder / "summary.json"));
  const auto loops = nlohmann::json::parse(content_of(folder / "loops.json"));
  EXPECT_EQ(summary["poses"], 200);
  EXPECT_EQ(summary["run"], loops["run"]);
  EXPECT_TRUE(loops["loops"].empty());
  const std::string id = summary["run"];
  EXPECT_THAT(content_of(folder / "trajectory.tum").substr(0, 100), HasSubstr(id));
  EXPECT_THAT(content_of(folder / "map_points.txt").substr(0, 100), HasSubstr(id));
}

TEST_F(OfflineSlam, TheSameBagGivesTheSameBytes) {
  const auto first = directory_.path() / "first", second = directory_.path() / "second";
  write_slam(run(), first, false);
  write_slam(run(), second, false);
  for (const char* name : {"trajectory.tum", "loops.json", "map_points.txt"})
    EXPECT_EQ(content_of(first / name), content_of(second / name)) << name;
}

TEST_F(OfflineSlam, ALaserThatIsInclinedIsRefused) {
  wall_.tilt_rad = 0.6;
  wall_.spoil_scan = [](int line, sensor_msgs::LaserScan&) {
    return line < 10;
  };  // it is at an end of its swing
  EXPECT_THAT(error(), HasSubstr("the laser is not level"));
}

TEST_F(OfflineSlam, ALaserThatTiltsIsRefusedAlthoughItIsLevelAtTimes) {
  wall_.tilt_rad = 0.6;
  EXPECT_THAT(error(), HasSubstr("the laser tilts: offline_modeler is for it"));
}

TEST_F(OfflineSlam, WithoutOdometryItSaysWhatIsMissing) {
  wall_.with_tf = false;
  EXPECT_THAT(error(), HasSubstr("no scan could be used of 200"));
}

TEST_F(OfflineSlam, ScansThatAreNotLaterAreLeftOut) {
  wall_.spoil_scan = [](int line, sensor_msgs::LaserScan& scan) {
    if (line == 50) scan.header.stamp -= ros::Duration(0.5);
    return true;
  };
  const SlamRun result = run();
  EXPECT_EQ(result.result.trajectory.size(), 199U);
  EXPECT_EQ(result.summary.dropped_scans.size(), 1U);
}

TEST_F(OfflineSlam, ScansWithoutAReturnAreTakenAsOdometrySays) {
  wall_.spoil_scan = [](int, sensor_msgs::LaserScan& scan) {
    for (float& range : scan.ranges) range = std::numeric_limits<float>::quiet_NaN();
    return true;
  };
  EXPECT_EQ(run().result.trajectory.size(), 200U);
}

TEST(SlamOptions, WrongUsageIsRefused) {
  const char* const arguments[] = {"offline_slam", "--no-such-option"};
  EXPECT_EQ(std::get<int>(parse_slam_options(2, arguments)), 2);
}

}  // namespace
}  // namespace ribbon_mapper::slam
