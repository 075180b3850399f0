// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/intake/input_watch.hpp"

#include <ros/master.h>

#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

#include "modeler/ros/intake/frame_tree.hpp"
#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kClockTolerance_s = 60.0;

/// Returns a time difference in seconds or days.
std::string apart(double seconds) {
  const double days = std::abs(seconds) / 86400.0;
  if (days < 1.0) return std::to_string(std::llround(std::abs(seconds))) + " s";
  return std::to_string(std::llround(days)) + " days";
}

/// Returns where else there are transforms, as behind a robot's name.
std::string others_tf() {
  ros::master::V_TopicInfo topics;
  if (!ros::master::getTopics(topics)) return "";
  std::string others;
  for (const ros::master::TopicInfo& topic : topics) {
    if (topic.datatype == "tf2_msgs/TFMessage" && topic.name.rfind("/tf", 0) != 0)
      others += " " + shown(topic.name);
  }
  if (others.empty()) return "";
  return "; there are transforms on" + others + ": remap /tf and /tf_static to these";
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
  if (scan.header.frame_id.size() <= kMaxFrameName)
    laser_frame_ = without_slash(scan.header.frame_id);
}

std::string InputWatch::complaint(const LineIntake& intake, const TransformBuffer& tf) {
  const bool silent = std::exchange(scans_before_, scans_) == scans_;
  const bool stuck = std::exchange(done_before_, intake.done()) == intake.done();
  if (scans_ == 0) return without_scans();
  if (!stuck || silent) return "";  // silent: a pause, or the end of a bag
  if (const auto fault = clock_fault(ros::Time::isSimTime(), ros::Time::now(), newest_stamp_)) {
    return "No lines are taken: " + *fault;
  }
  if (tf.received() == 0) return "No lines are taken: there is nothing on /tf yet" + others_tf();
  if (intake.waits_for().empty()) return "";
  return "No lines are taken, waiting: " + intake.waits_for() + frames_advice(intake, tf);
}

std::string InputWatch::frames_advice(const LineIntake& intake, const TransformBuffer& tf) const {
  const FrameTree tree(tf.core());
  const Frames& frames = intake.options().frames;
  if (missing_frames(tree, frames).empty() && tree.has(laser_frame_)) return "";
  const std::string text = "; tf has " + tree.text(laser_frame_);
  const auto chosen = choose_frames(tree, laser_frame_, frames, {});
  const std::string settings =
      chosen ? settings_text(frames, *chosen, "", "_frame:=") : std::string();
  if (!settings.empty()) return text + ": set " + settings + ", if no localisation is to come";
  return text + ": are ~map_frame, ~odom_frame and ~base_frame right?";
}

std::string InputWatch::lateness(const LineIntake& intake, const TransformBuffer& tf) const {
  double latest_s = intake.options().transform_timeout_s;
  std::string latest;
  for (const std::string& frame : FrameTree(tf.core()).chain_from(laser_frame_)) {
    const double delay_s = tf.delay_s(frame);
    if (delay_s <= latest_s || delay_s > kClockTolerance_s) continue;
    latest_s = delay_s, latest = frame;
  }
  if (latest.empty()) return "";
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "Transforms of " << shown(latest) << " come "
       << latest_s << " s after their stamps, and lines wait "
       << intake.options().transform_timeout_s
       << " s: raise ~transform_timeout (transform_timeout:=" << std::setprecision(0)
       << std::ceil(latest_s + 0.5) << ")";
  return text.str();
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
                 : text + ": it carries " + shown(topic.datatype) + ", not sensor_msgs/LaserScan";
    }
    if (topic.datatype == "sensor_msgs/LaserScan") others += " " + shown(topic.name);
  }
  return text + ": nobody publishes it" + (others.empty() ? "" : "; there are scans on" + others);
}

}  // namespace ribbon_mapper
