// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/ros/tour_publisher.hpp"

#include <ros/names.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Bool.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cstdlib>

#include "modeler/ros/messages/message_conversions.hpp"
#include "sim/ros/robot_messages.hpp"
#include "sim/ros/truth_messages.hpp"

namespace ribbon_mapper::sim {
namespace {

constexpr double kMapRate_hz = 30.0;
constexpr Time kPathStep = std::chrono::milliseconds(500);

Time end_of(const Scan& scan) {
  return scan.stamp +
         from_seconds((static_cast<double>(scan.ranges_m.size()) - 1.0) * scan.time_increment_s);
}

}  // namespace

TourPublisher::TourPublisher(ros::NodeHandle& node, const World& world, Tour& tour,
                             const SimulatorFrames& frames, bool has_localisation)
    : tour_(tour),
      frames_(frames),
      has_localisation_(has_localisation),
      truth_(world),
      echo_(node),
      next_scan_(tour.next_scan()) {
  // Long queues: on a busy machine, a late message is better than a lost one.
  clock_ = node.advertise<rosgraph_msgs::Clock>("/clock", 1000);
  tf_ = node.advertise<tf2_msgs::TFMessage>("/tf", 10000);
  joints_ = node.advertise<sensor_msgs::JointState>("joint_states", 10000);
  odometry_ = node.advertise<nav_msgs::Odometry>("base_odometry/odom", 10000);
  true_pose_ = node.advertise<nav_msgs::Odometry>("base_pose_ground_truth", 10000);
  scan_ = node.advertise<sensor_msgs::LaserScan>("tilt_scan", 10000);
  base_scan_ = node.advertise<sensor_msgs::LaserScan>("base_scan", 10000);
  truth_planes_ = node.advertise<PlaneArray>("ground_truth/planes", 1, true);
  true_path_ = node.advertise<nav_msgs::Path>("ground_truth/trajectory", 1, true);
  world_ = node.advertise<visualization_msgs::MarkerArray>("ground_truth/world", 1, true);
  finished_ = node.advertise<std_msgs::Bool>("tour_finished", 1, true);
  world_.publish(world_markers(world, map_header(Time(0))));
  publish_finished(false);
  if (has_localisation_)
    corrected_trajectory_ =
        node.subscribe("corrected_trajectory", 1, &TourPublisher::on_corrected_trajectory, this);
}

void TourPublisher::on_corrected_trajectory(const nav_msgs::Path& path) {
  if (path.poses.empty()) return;
  const geometry_msgs::PoseStamped& newest = path.poses.back();
  const std::optional<Pose> pose = pose_of(newest.pose);
  if (!pose || path.header.frame_id != frames_.map) return;  // the modeler says what is wrong
  const std::lock_guard<std::mutex> lock(correction_mutex_);
  if (is_over_) corrected_ = StampedPose{time_of(newest.header.stamp), *pose};
}

bool TourPublisher::has_subscribers(const std::string& topic) const {
  const std::size_t colon = topic.find(':');
  const std::string name = ros::names::resolve(topic.substr(0, colon));
  const int count = colon == std::string::npos ? 1 : std::atoi(topic.c_str() + colon + 1);
  for (const ros::Publisher* publisher :
       {&clock_, &tf_, &joints_, &odometry_, &true_pose_, &scan_, &base_scan_})
    if (publisher->getTopic() == name)
      return static_cast<int>(publisher->getNumSubscribers()) >= count;
  return true;
}

Time TourPublisher::in_tour(Time now) const {
  return std::clamp(now - kStart, Time(0), tour_.duration());
}

Pose TourPublisher::T_odom_base(Time at) const {
  if (has_localisation_) return tour_.T_odom_base(at);
  return tour_.T_map_odom_at_start() * tour_.T_odom_base(at);
}

Pose TourPublisher::T_map_odom(Time now) const {
  const std::lock_guard<std::mutex> lock(correction_mutex_);
  if (!corrected_) return tour_.T_map_odom(in_tour(now));
  return corrected_->T_map_base * T_odom_base(in_tour(corrected_->stamp)).inverse();
}

std_msgs::Header TourPublisher::map_header(Time now) const {
  std_msgs::Header header;
  header.frame_id = frames_.map;
  header.stamp = stamp_of(now);
  return header;
}

void TourPublisher::tick(Time now) {
  if (!echo_.wait_for(stamp_of(now_))) ++lost_joints_;
  now_ = now;
  rosgraph_msgs::Clock clock;
  clock.clock = stamp_of(now);
  clock_.publish(clock);
  publish_base(now);
  publish_joints(now);
  if (has_localisation_) publish_localisation(now);
  publish_scans(now);
  publish_base_scans(now);
  publish_true_path(now);
}

void TourPublisher::publish_base(Time now) {
  const Time at = in_tour(now);
  const ros::Time stamp = stamp_of(now);
  const Pose T_odom_base = this->T_odom_base(at);
  const Velocity velocity = tour_.true_velocity(at);
  tf2_msgs::TFMessage tf;
  tf.transforms.push_back(stamped_transform(frames_.odom, frames_.base, T_odom_base, stamp));
  tf_.publish(tf);
  odometry_.publish(odometry_message(frames_.odom, frames_.base, T_odom_base, velocity, stamp));
  true_pose_.publish(
      odometry_message(frames_.map, frames_.base, tour_.true_T_map_base(at), velocity, stamp));
}

void TourPublisher::publish_joints(Time now) {
  // The tilt moves before the tour as well: it is a function of time alone.
  const Time at = std::max(now - kStart, Time(0));
  joints_.publish(joint_message(tour_.tilt_angle(at), stamp_of(now)));
}

void TourPublisher::publish_localisation(Time now) {
  const auto stamp_of_tick = [](std::size_t tick) {
    return kFirstTick + from_seconds(static_cast<double>(tick) / kMapRate_hz);
  };
  tf2_msgs::TFMessage tf;
  for (; stamp_of_tick(map_ticks_) <= now; ++map_ticks_) {
    const Time stamp = stamp_of_tick(map_ticks_);
    tf.transforms.push_back(
        stamped_transform(frames_.map, frames_.odom, T_map_odom(stamp), stamp_of(stamp)));
  }
  if (!tf.transforms.empty()) tf_.publish(tf);
}

void TourPublisher::publish_scans(Time now) {
  // A driver sends a scan when its last beam is in.
  while (next_scan_ && kStart + end_of(*next_scan_) <= now) {
    const ros::Time stamp = stamp_of(kStart + next_scan_->stamp);
    scan_.publish(scan_message(*next_scan_, kTiltLaserFrame, stamp));
    truth_.add(*next_scan_);
    ++lines_;
    next_scan_ = tour_.next_scan();
  }
}

void TourPublisher::publish_base_scans(Time now) {
  for (; base_lines_ < tour_.base_line_count(); ++base_lines_) {
    if (kStart + tour_.base_scan_end(base_lines_) > now) return;
    if (base_scan_.getNumSubscribers() == 0) continue;  // its rays are the most of the work
    const Scan scan = tour_.base_scan(base_lines_);
    base_scan_.publish(scan_message(scan, kBaseLaserFrame, stamp_of(kStart + scan.stamp)));
  }
}

void TourPublisher::publish_true_path(Time now) {
  if (!path_.empty() && now < path_.back().stamp + kPathStep) return;
  if (now > kStart + tour_.duration() + kPathStep) return;
  path_.push_back({now, tour_.true_T_map_base(in_tour(now))});
  if (true_path_.getNumSubscribers() > 0) true_path_.publish(path_message(path_, frames_.map, now));
}

void TourPublisher::publish_truth() {
  true_path_.publish(path_message(path_, frames_.map, now_));
  truth_planes_.publish(truth_message(truth_.planes(), map_header(now_)));
}

void TourPublisher::publish_finished(bool finished) {
  {
    const std::lock_guard<std::mutex> lock(correction_mutex_);
    is_over_ = finished;
  }
  std_msgs::Bool message;
  message.data = finished;
  finished_.publish(message);
}

}  // namespace ribbon_mapper::sim
