// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A recording with both lasers, whose odometry the level one refines.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "modeler/ros/offline/offline_run.hpp"
#include "sim/ros/tour_recorder.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr double kDrift = 6.0;

/// A tour of 12 s with a strong drift, recorded with both lasers.
struct Recording {
  Recording() {
    ros::Time::init();
    const sim::World world = sim::World::load(PROJECT_DIR "/test/ros/room.sdf", {});
    sim::TourConfig config;
    config.localisation.drift = kDrift;
    sim::Tour tour(world, sim::Route::load(PROJECT_DIR "/test/ros/room.route.yaml"), config);
    sim::RecorderOptions recorder;
    recorder.longest_s = 12.0;
    recorder.base_laser = true;
    for (const StampedPose& pose : sim::record_tour(tour, recorder, bag()))
      truth[pose.stamp] = pose.T_map_base;
  }
  fs::path bag() const { return directory.path() / "both.bag"; }
  OfflineOptions options(const std::string& base_scan) const {
    OfflineOptions options;
    options.bags = {bag()};
    options.config = PROJECT_DIR "/config/pr2.yaml";
    options.trajectory = "self";
    options.base_scan = base_scan;
    options.bag.scan_topic = "tilt_scan";
    return options;
  }
  OfflineRun run(const std::string& base_scan) const {
    return model_bags(options(base_scan), [](const Progress&) {});
  }
  /// Returns the error of the heading since the first pose, RMS [rad].
  double heading_error_rad(const OfflineRun& run) const {
    const auto error = [&](const StampedPose& pose) {
      const auto at = std::min_element(truth.begin(), truth.end(), [&](auto& a, auto& b) {
        return std::abs((a.first - pose.stamp).count()) < std::abs((b.first - pose.stamp).count());
      });
      return yaw_of(at->second.inverse(Eigen::Isometry) * pose.T_map_base);
    };
    const double start = error(run.trajectory.front());
    double sum = 0.0;
    for (const StampedPose& pose : run.trajectory) sum += std::pow(error(pose) - start, 2);
    return std::sqrt(sum / static_cast<double>(run.trajectory.size()));
  }
  TemporaryDirectory directory;
  std::map<Time, Pose> truth;
};

TEST(BaseScans, RefineTheOdometryOfTheEstimate) {
  const Recording recording;
  const OfflineRun without = recording.run(""), with = recording.run("base_scan");
  ASSERT_TRUE(with.summary.estimate && with.summary.estimate->base_scans);
  EXPECT_FALSE(without.summary.estimate->base_scans);
  const BaseScanFigures& figures = *with.summary.estimate->base_scans;
  EXPECT_EQ(figures.topic, "/base_scan");
  EXPECT_GE(figures.scans, 470U);
  EXPECT_GT(figures.matched, 100U);
  EXPECT_TRUE(figures.dropped.empty());
  EXPECT_EQ(with.trajectory.size(), without.trajectory.size());
  EXPECT_LT(recording.heading_error_rad(with), 0.7 * recording.heading_error_rad(without));
  EXPECT_THAT(with.summary.trajectory, HasSubstr("a level laser"));
  const auto json = nlohmann::json::parse(summary_to_json(with.summary, "id"));
  EXPECT_EQ(json["estimate"]["base_laser"]["matched"], figures.matched);
}

TEST(BaseScans, ATiltingLaserIsRefusedWithTheReason) {
  const Recording recording;
  try {
    recording.run("tilt_scan");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("not level"));
    EXPECT_THAT(error.what(), HasSubstr("--base-scan"));
  }
}

TEST(BaseScans, NeedTheEstimate) {
  const char* arguments[] = {"offline_modeler", "--bag", "a.bag", "--base-scan", "base_scan"};
  const auto options = parse_offline_options(5, arguments);
  ASSERT_TRUE(std::holds_alternative<int>(options));
  EXPECT_EQ(std::get<int>(options), 2);
}

}  // namespace
}  // namespace ribbon_mapper
