// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/node/base_laser_input.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr double kTimeout_s = 2.0;

Moment moment(double seconds) {
  return {ros::Time(100.0 + seconds), ros::WallTime(500.0 + seconds)};
}

Time line_at(double seconds) { return from_seconds(100.0 + seconds); }

/// A level laser on a base that stands in odom, and the input of its scans.
struct Input {
  Input() {
    ros::Time::init();
    for (const auto& [parent, child] : {std::pair("odom", "base"), std::pair("base", "laser")}) {
      geometry_msgs::TransformStamped transform;
      transform.header.frame_id = parent;
      transform.header.stamp = ros::Time(100.0);
      transform.child_frame_id = child;
      transform.transform.rotation.w = 1.0;
      tf.setTransform(transform, "test", true);
    }
    options.frames = {"odom", "odom", "base"};
    options.transform_timeout_s = kTimeout_s;
    input.emplace(options, "/base_scan");
  }
  void scan(double seconds, const Moment& now) {
    sensor_msgs::LaserScan scan;
    scan.header.frame_id = "laser";
    scan.header.stamp = stamp_of(line_at(seconds));
    scan.angle_min = -1.5F, scan.angle_max = 1.5F, scan.angle_increment = 0.01F;
    scan.range_min = 0.1F, scan.range_max = 30.0F;
    scan.ranges.assign(301, 3.0F);
    input->add(scan, now);
    input->hand_over(tf, now, worker);
  }
  std::string summary() {
    diagnostic_updater::DiagnosticStatusWrapper report;
    input->diagnose(0, report);
    return report.message;
  }
  tf2::BufferCore tf;
  IntakeOptions options;
  EstimateWorker worker{{}, {}, true};
  std::optional<BaseLaserInput> input;
};

TEST(BaseLaserInput, ALineWaitsForTheScansUpToIt) {
  Input base;
  EXPECT_FALSE(base.input->lets_pass(line_at(0.5), moment(0.5)));
  base.scan(0.49, moment(0.6));
  EXPECT_FALSE(base.input->lets_pass(line_at(0.5), moment(0.6)));
  base.scan(0.515, moment(0.7));
  EXPECT_TRUE(base.input->lets_pass(line_at(0.5), moment(0.7)));
  EXPECT_FALSE(base.input->lets_pass(line_at(0.525), moment(0.7)));
  EXPECT_FALSE(base.input->is_silent());
}

TEST(BaseLaserInput, ASilentLaserDelaysOneLineOnly) {
  Input base;
  base.scan(0.0, moment(0.0));
  EXPECT_FALSE(base.input->lets_pass(line_at(0.5), moment(1.0)));
  EXPECT_FALSE(base.input->lets_pass(line_at(0.5), moment(1.0 + kTimeout_s)));
  EXPECT_TRUE(base.input->lets_pass(line_at(0.5), moment(1.1 + kTimeout_s)));
  EXPECT_TRUE(base.input->lets_pass(line_at(0.525), moment(1.1 + kTimeout_s)));
  EXPECT_TRUE(base.input->is_silent());
  EXPECT_EQ(base.summary(), "silent: the recorded odometry is used");
}

TEST(BaseLaserInput, LinesWaitAgainOnceScansComeAgain) {
  Input base;
  EXPECT_FALSE(base.input->lets_pass(line_at(0.5), moment(0.5)));
  EXPECT_TRUE(base.input->lets_pass(line_at(0.5), moment(0.6 + kTimeout_s)));
  EXPECT_EQ(base.summary(), "no scan has come on /base_scan: the recorded odometry is used");
  base.scan(4.0, moment(4.0));
  EXPECT_TRUE(base.input->lets_pass(line_at(3.9), moment(4.0)));
  EXPECT_FALSE(base.input->is_silent());
  EXPECT_FALSE(base.input->lets_pass(line_at(4.1), moment(4.0)));
}

TEST(BaseLaserInput, ForgetsTheRunBefore) {
  Input base;
  base.scan(10.0, moment(10.0));
  EXPECT_TRUE(base.input->lets_pass(line_at(9.0), moment(10.0)));
  base.input->start_next_run("the clock was set back");
  EXPECT_FALSE(base.input->lets_pass(line_at(1.0), moment(11.0)));
  base.scan(1.1, moment(11.1));
  EXPECT_TRUE(base.input->lets_pass(line_at(1.0), moment(11.1)));
}

TEST(BaseLaserInput, HandsScansOverToTheEstimate) {
  Input base;
  base.scan(0.0, moment(0.0));
  base.scan(1.0, moment(1.0));  // due after half a second, though the base stands still
  base.worker.close();
  EstimateNews news;
  while (!news.is_closed) news = base.worker.take_news();
  EXPECT_EQ(news.status.base_scans, 2U);
  EXPECT_TRUE(news.refused_base_scans.empty());
}

}  // namespace
}  // namespace ribbon_mapper::slam
