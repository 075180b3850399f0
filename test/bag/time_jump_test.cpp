// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Simulated time is set back: what is kept, what is dropped, and what is held back.

#include <console_bridge/console.h>
#include <gmock/gmock.h>

#include "modeler/ros/intake/line_intake.hpp"
#include "modeler/ros/intake/transform_buffer.hpp"

namespace ribbon_mapper {
namespace {

using testing::IsEmpty;

/// Collects what tf2 would print.
class PrintedByTf : public console_bridge::OutputHandler {
 public:
  PrintedByTf() { console_bridge::useOutputHandler(this); }
  ~PrintedByTf() override { console_bridge::restorePreviousOutputHandler(); }
  void log(const std::string& text, console_bridge::LogLevel, const char*, int) override {
    texts.push_back(text);
  }
  std::vector<std::string> texts;
};

geometry_msgs::TransformStamped transform(const char* parent, const char* child, double stamp_s,
                                          double x_m = 0.0) {
  geometry_msgs::TransformStamped message;
  message.header.frame_id = parent, message.child_frame_id = child;
  message.header.stamp = ros::Time(stamp_s);
  message.transform.translation.x = x_m, message.transform.rotation.w = 1.0;
  return message;
}

sensor_msgs::LaserScan scan(double stamp_s) {
  sensor_msgs::LaserScan message;
  message.header.frame_id = "laser";
  message.header.stamp = ros::Time(stamp_s);
  message.angle_max = 0.1F, message.angle_increment = 0.1F;
  message.range_max = 10.0F, message.ranges = {1.0F, 1.0F};
  return message;
}

/// A robot that stands still during a run. The last line of a run lacks its transforms.
class TimeJump : public testing::Test {
 protected:
  TimeJump() {
    ros::Time::init();
    tf2_msgs::TFMessage fixed;
    fixed.transforms.push_back(transform("base_footprint", "laser", 0.0));
    tf_.add(fixed, true);
  }
  static void set_clock(double seconds) { ros::Time::setNow(ros::Time(seconds)); }
  void publish_transforms(double stamp_s, double x_m) {
    tf2_msgs::TFMessage message;
    message.transforms = {transform("map", "odom_combined", stamp_s, x_m),
                          transform("odom_combined", "base_footprint", stamp_s)};
    tf_.add(message, false);
    EXPECT_EQ(tf_.counts().refused, 0u);
  }
  void publish_transforms_of_a_run(double x_m) {
    for (int i = 0; i < 30; ++i) publish_transforms(1000.0 + 0.1 * i, x_m);
  }
  void publish_scans_of_a_run() {
    for (int i = 0; i < 30; ++i) intake_.add(scan(1000.001 + 0.1 * i), Moment::now());
  }
  void jump() {
    tf_.start_next_run();
    intake_.start_next_run("the clock was set back");
  }
  /// Takes all lines that are ready and returns where their bases were.
  std::vector<double> take_lines() {
    std::vector<double> x_m;
    while (const auto line = intake_.take_next(tf_.core(), Moment::now()))
      x_m.push_back(line->poses.T_map_base.translation().x());
    return x_m;
  }

  PrintedByTf printed_;
  TransformBuffer tf_{120.0, {}};
  LineLog log_;
  LineIntake intake_{{}, log_};
};

TEST_F(TimeJump, ANewRunIsNotAnsweredWithTransformsOfTheOldOne) {
  set_clock(1000.0);
  publish_transforms_of_a_run(1.0);
  publish_scans_of_a_run();
  EXPECT_EQ(take_lines(), std::vector<double>(29, 1.0));
  jump();
  publish_scans_of_a_run();
  EXPECT_THAT(take_lines(), IsEmpty());
  publish_transforms_of_a_run(2.0);
  EXPECT_EQ(take_lines(), std::vector<double>(29, 2.0));
  EXPECT_THAT(printed_.texts, IsEmpty());
}

TEST_F(TimeJump, MessagesThatOvertakeTheClockAreHeldBack) {
  set_clock(1000.0);
  publish_transforms_of_a_run(1.0);
  publish_scans_of_a_run();
  EXPECT_EQ(take_lines(), std::vector<double>(29, 1.0));
  set_clock(1003.0);
  publish_scans_of_a_run();
  publish_transforms_of_a_run(2.0);
  EXPECT_THAT(take_lines(), IsEmpty());
  set_clock(1000.0);
  jump();
  log_ = {};
  EXPECT_EQ(take_lines(), std::vector<double>(29, 2.0));
  EXPECT_EQ(log_.lines(), 30u);
  EXPECT_EQ(log_.dropped_lines(), 0u);
  EXPECT_THAT(printed_.texts, IsEmpty());
}

TEST_F(TimeJump, LateMessagesOfTheOldRunAreDropped) {
  set_clock(1000.0);
  publish_transforms_of_a_run(1.0);
  publish_scans_of_a_run();
  take_lines();
  jump();
  publish_transforms(1003.0, 1.0);
  intake_.add(scan(1002.951), Moment::now());
  publish_transforms_of_a_run(2.0);
  publish_scans_of_a_run();
  EXPECT_EQ(take_lines(), std::vector<double>(29, 2.0));
  EXPECT_THAT(printed_.texts, IsEmpty());
}

TEST_F(TimeJump, AClockThatRunsToTheEndOfTimeThrowsNothing) {
  set_clock(1000.0);
  publish_transforms_of_a_run(1.0);
  publish_scans_of_a_run();
  EXPECT_EQ(take_lines().size(), 29u);  // the last one waits
  ros::Time::setNow(ros::TIME_MAX);
  EXPECT_THAT(take_lines(), IsEmpty());
  intake_.add(scan(4.2e9), Moment::now());
  EXPECT_THAT(take_lines(), IsEmpty());
}

TEST_F(TimeJump, AResetWithinARunDropsWhatWaits) {
  set_clock(1000.0);
  publish_scans_of_a_run();
  EXPECT_THAT(take_lines(), IsEmpty());
  intake_.restart("reset");
  EXPECT_EQ(intake_.waiting(), 0u);
  EXPECT_EQ(log_.dropped_by_reason().at("reset"), 30u);
}

}  // namespace
}  // namespace ribbon_mapper
