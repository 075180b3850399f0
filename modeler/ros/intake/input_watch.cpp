// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/intake/input_watch.hpp"

#include <ros/master.h>

#include <cmath>
#include <utility>

namespace ribbon_mapper {
namespace {

constexpr double kClockTolerance_s = 60.0;

/// Returns a time difference in seconds or days.
std::string apart(double seconds) {
  const double days = std::abs(seconds) / 86400.0;
  if (days < 1.0) return std::to_string(std::llround(std::abs(seconds))) + " s";
  return std::to_string(std::llround(days)) + " days";
}

}  // namespace

std::optional<std::string> clock_fault(bool use_sim_time, const ros::Time& clock,
                                       const ros::Time& newest_stamp) {
  if (use_sim_time && clock.isZero()) {
    return "/use_sim_time is true, but nobody publishes /clock: play the bag with --clock, or set "
           "/use_sim_time to false on a robot";
  }
  const double gap_s = newest_stamp.toSec() - clock.toSec();
  if (std::abs(gap_s) < kClockTolerance_s) return std::nullopt;
  const std::string fact =
      "scans are stamped " + apart(gap_s) + (gap_s > 0.0 ? " after" : " before") + " the clock: ";
  if (use_sim_time) {
    return fact + "/use_sim_time is true, but the laser's driver stamps by another clock";
  }
  return fact +
         "is a bag played without /use_sim_time true and --clock, or is a computer's clock "
         "not set?";
}

void InputWatch::saw(const sensor_msgs::LaserScan& scan) {
  ++scans_;
  newest_stamp_ = scan.header.stamp;
}

std::string InputWatch::complaint(const LineIntake& intake, std::size_t transforms) {
  const bool silent = std::exchange(scans_before_, scans_) == scans_;
  const bool stuck = std::exchange(done_before_, intake.done()) == intake.done();
  if (scans_ == 0) return without_scans();
  if (!stuck || silent) return "";  // silent: a pause, or the end of a bag
  if (const auto fault = clock_fault(ros::Time::isSimTime(), ros::Time::now(), newest_stamp_)) {
    return "No lines are taken: " + *fault;
  }
  if (transforms == 0) return "No lines are taken: there is nothing on /tf yet";
  return intake.waits_for().empty() ? "" : "No lines are taken, waiting: " + intake.waits_for();
}

std::string InputWatch::without_scans() const {
  std::string text = "Waiting for scans on " + scan_topic_;
  if (ros::Time::isSimTime() && ros::Time::now().isZero()) {
    text += "; /use_sim_time is true, but there is no /clock either";
  }
  ros::master::V_TopicInfo topics;
  if (!ros::master::getTopics(topics)) return text;
  std::string others;
  for (const ros::master::TopicInfo& topic : topics) {
    if (topic.name == scan_topic_) {
      return topic.datatype == "sensor_msgs/LaserScan"
                 ? text + ": it is published, but nothing has come yet"
                 : text + ": it carries " + topic.datatype + ", not sensor_msgs/LaserScan";
    }
    if (topic.datatype == "sensor_msgs/LaserScan") others += " " + topic.name;
  }
  return text + ": nobody publishes it" + (others.empty() ? "" : "; there are scans on" + others);
}

}  // namespace ribbon_mapper
