// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/time_offset.hpp"

#include <gmock/gmock.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>

#include <functional>
#include <memory>

#include "modeler/ros/offline/offline_run.hpp"
#include "sim/ros/tour_recorder.hpp"
#include "test/bag/wall_bag.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

constexpr double kIncrement_s = 0.025 / 1440.0;  // of the simulated laser
const std::string kPreset = PROJECT_DIR "/config/pr2.yaml";

/// A recording of a simulated robot whose stamps are right, and copies of it with other scans.
class Timing : public testing::Test {
 protected:
  using Change = std::function<bool(int line, sensor_msgs::LaserScan& scan)>;

  static void SetUpTestSuite() {
    ros::Time::init();
    directory_ = std::make_unique<TemporaryDirectory>();
    const sim::World world = sim::World::load(PROJECT_DIR "/test/ros/room.sdf", {});
    sim::TourConfig config;
    config.localisation.drift = 0.0;
    sim::Tour tour(world, sim::Route::load(PROJECT_DIR "/test/ros/room.route.yaml"), config);
    sim::RecorderOptions recorder;
    recorder.longest_s = 12.0;
    sim::record_tour(tour, recorder, right());
  }
  static void TearDownTestSuite() { directory_.reset(); }

  static fs::path right() { return directory_->path() / "right.bag"; }

  /// Writes a copy; `change` returns false to leave a scan out.
  static fs::path changed(const Change& change) {
    const fs::path file = directory_->path() / "changed.bag";
    rosbag::Bag from(right().string()), to(file.string(), rosbag::bagmode::Write);
    int line = 0;
    for (const rosbag::MessageInstance& message : rosbag::View(from)) {
      const auto scan = message.instantiate<sensor_msgs::LaserScan>();
      if (!scan) {
        to.write(message.getTopic(), message.getTime(), message);
      } else if (change(line++, *scan)) {
        to.write(message.getTopic(), message.getTime(), *scan);
      }
    }
    return file;
  }
  static fs::path with_increment(double factor) {
    return changed([=](int, sensor_msgs::LaserScan& scan) {
      scan.time_increment *= static_cast<float>(factor);
      return true;
    });
  }
  static std::optional<TimeOffset> estimate(const fs::path& bag) {
    return estimate_time_offset({bag}, {}, ModelerConfig{});
  }
  static std::string report(const fs::path& bag, const BagOptions& options = {}) {
    BagReport report;
    report_time_offset({bag}, options, kPreset, report);
    return report.text();
  }

  static std::unique_ptr<TemporaryDirectory> directory_;
};

std::unique_ptr<TemporaryDirectory> Timing::directory_;

TEST_F(Timing, AnyOffsetUpToASecondIsFound) {
  for (const double error_s : {-1.0, -0.35, 0.1, 0.7}) {
    const auto found = estimate(changed([=](int, sensor_msgs::LaserScan& scan) {
      scan.header.stamp += ros::Duration(error_s);
      return true;
    }));
    ASSERT_TRUE(found) << error_s;
    EXPECT_NEAR(found->offset_s, -error_s, 0.003);
    EXPECT_FALSE(found->time_increment_s);
  }
}

TEST_F(Timing, DriftIsNoOffset) {
  const sim::World world = sim::World::load(PROJECT_DIR "/test/ros/room.sdf", {});
  for (const std::uint64_t seed : {1, 2, 4}) {
    sim::TourConfig config;
    config.localisation.drift = 10.0;
    config.seed = seed;
    sim::Tour tour(world, sim::Route::load(PROJECT_DIR "/test/ros/room.route.yaml"), config);
    const fs::path bag = directory_->path() / "drift.bag";
    sim::record_tour(tour, {}, bag.string());
    EXPECT_THAT(report(bag), Not(HasSubstr("WARNING"))) << "seed " << seed;
  }
}

TEST_F(Timing, TheWarningNamesTheOptionThatMendsIt) {
  const fs::path bag = changed([](int, sensor_msgs::LaserScan& scan) {
    scan.header.stamp += ros::Duration(0.35);
    return true;
  });
  EXPECT_THAT(report(bag), HasSubstr("WARNING  up and down sweeps do not agree"));
  BagOptions options;
  options.intake.scan_time_offset_s = estimate(bag)->offset_s;
  EXPECT_THAT(report(bag, options), Not(HasSubstr("WARNING")));
}

TEST_F(Timing, AWrongTimeIncrementIsNoOffset) {
  for (const double factor : {0.05, 6.0}) {
    const fs::path bag = with_increment(factor);
    const auto found = estimate(bag);
    ASSERT_TRUE(found) << factor;
    ASSERT_TRUE(found->time_increment_s) << factor;
    EXPECT_NEAR(*found->time_increment_s, kIncrement_s, 0.02 * kIncrement_s);
    EXPECT_LT(std::abs(found->offset_s), 0.002) << factor;
    EXPECT_THAT(report(bag), Not(HasSubstr("scan_time_offset")));
  }
}

TEST_F(Timing, LinesThatAreLeftOutAreNoWrongTimeIncrement) {
  const fs::path bag = changed([](int line, sensor_msgs::LaserScan&) { return line % 2 == 0; });
  EXPECT_THAT(report(bag), Not(HasSubstr("WARNING")));
}

TEST_F(Timing, NothingIsProposedWhereTheMotionCannotTell) {
  WallBag wall;
  wall.tilt_rad = 0.0;
  const fs::path file = directory_->path() / "still.bag";
  wall.write(file);
  EXPECT_FALSE(estimate(file));
  EXPECT_THAT(report(file), HasSubstr("the motion does not show"));
}

/// A tilt with a period of 2 s whose stamps are off by 0.35 s could also be off by -0.65 s: the
/// wall is then tilted the other way.
TEST_F(Timing, SeveralOffsetsThatFitAreListed) {
  WallBag wall;
  wall.lines = 400;
  wall.spoil_scan = [](int, sensor_msgs::LaserScan& scan) {
    scan.header.stamp += ros::Duration(0.35);
    return true;
  };
  const fs::path file = directory_->path() / "mirrored.bag";
  wall.write(file);
  EXPECT_FALSE(estimate(file));
  EXPECT_THAT(report(file), HasSubstr("fits several values of scan_time_offset"));
}

TEST_F(Timing, AWrongTimeIncrementIsSaidWithTheModel) {
  OfflineOptions options;
  options.config = kPreset;
  for (const float factor : {1.0F, 0.05F}) {
    options.bags = {changed([&](int, sensor_msgs::LaserScan& scan) {
      scan.time_increment *= factor;
      scan.scan_time = 0.025F;
      return true;
    })};
    const std::string text = summary_text(model_bags(options, [](const Progress&) {}).summary);
    const bool is_said = text.find("WARNING time_increment is 0.87 us") != std::string::npos;
    EXPECT_EQ(factor != 1.0F, is_said) << text;
    EXPECT_EQ(is_said, text.find("and lines come every 25.0 ms: ") != std::string::npos) << text;
  }
}

}  // namespace
}  // namespace ribbon_mapper
