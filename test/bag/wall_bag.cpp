// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "test/bag/wall_bag.hpp"

#include <rosbag/bag.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

namespace ribbon_mapper {
namespace {

constexpr int kBeams = 201;
constexpr double kHalfAngle = 0.5, kPeriod_s = 0.025, kHeight_m = 1.2, kWall_m = 3.0;

geometry_msgs::TransformStamped transform(const std::string& parent, const std::string& child,
                                          double stamp_s, double height_m = 0.0,
                                          double tilt_rad = 0.0) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = ros::Time(stamp_s);
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform.translation.z = height_m;
  message.transform.rotation.y = std::sin(0.5 * tilt_rad);
  message.transform.rotation.w = std::cos(0.5 * tilt_rad);
  return message;
}

}  // namespace

double WallBag::tilt_at(double seconds) const {
  const double phase = std::fmod(seconds + 10.0, 2.0);
  return tilt_rad * (phase < 1.0 ? 2.0 * phase - 1.0 : 3.0 - 2.0 * phase);
}

sensor_msgs::LaserScan WallBag::scan(int line) const {
  const double seconds = line * kPeriod_s;
  std::mt19937 random(static_cast<unsigned>(line));
  std::normal_distribution<double> noise(0.0, 0.005);
  sensor_msgs::LaserScan message;
  message.header.stamp = ros::Time(first_stamp_s + seconds);
  message.header.frame_id = laser_frame;
  message.angle_min = -kHalfAngle, message.angle_max = kHalfAngle;
  message.angle_increment = 2.0 * kHalfAngle / (kBeams - 1);
  message.range_min = 0.1F, message.range_max = 30.0F;
  for (int i = 0; i < kBeams; ++i) {
    const double angle = message.angle_min + i * message.angle_increment;
    message.ranges.push_back(static_cast<float>(
        kWall_m / (std::cos(tilt_at(seconds)) * std::cos(angle)) + noise(random)));
  }
  return message;
}

tf2_msgs::TFMessage WallBag::tf(double seconds) const {
  const double stamp_s = first_stamp_s + seconds;
  tf2_msgs::TFMessage message;
  if (with_map) {
    message.transforms.push_back(transform(slash + "map", slash + "odom_combined", stamp_s));
  }
  message.transforms.push_back(
      transform(slash + "odom_combined", slash + "base_footprint", stamp_s));
  message.transforms.push_back(transform(slash + "torso_lift_link", slash + "laser_tilt_link",
                                         stamp_s, 0.0, tilt_at(seconds)));
  return message;
}

void WallBag::write(const std::filesystem::path& file) const {
  rosbag::Bag bag(file.string(), rosbag::bagmode::Write);
  if (is_compressed) bag.setCompression(rosbag::compression::BZ2);
  tf2_msgs::TFMessage fixed;
  fixed.transforms.push_back(
      transform(slash + "base_footprint", slash + "torso_lift_link", first_stamp_s, kHeight_m));
  const double end_s = lines * kPeriod_s + 0.2;
  const double static_s = static_last ? end_s : -0.1;
  if (spoil_static) spoil_static(fixed);
  if (with_static) bag.write(tf_space + "/tf_static", ros::Time(1000.0 + static_s), fixed);
  for (int tick = -2; tick * 0.01 < end_s && with_tf; ++tick) {
    const double seconds = tick * 0.01;
    if (seconds > tf_gap_begin_s && seconds < tf_gap_end_s) continue;
    tf2_msgs::TFMessage message = tf(seconds);
    if (spoil_tf) spoil_tf(message);
    tf2_msgs::TFMessage late;
    const auto is_late = [&](const auto& t) { return t.child_frame_id == late_frame; };
    auto& all = message.transforms;
    std::copy_if(all.begin(), all.end(), std::back_inserter(late.transforms), is_late);
    all.erase(std::remove_if(all.begin(), all.end(), is_late), all.end());
    if (!all.empty()) bag.write(tf_space + "/tf", ros::Time(1000.0 + seconds), message);
    if (late.transforms.empty()) continue;
    bag.write(tf_space + "/tf", ros::Time(1000.0 + seconds + late_s), late);
  }
  for (int line = 0; line < lines; ++line) {
    sensor_msgs::LaserScan message = scan(line);
    if (spoil_scan && !spoil_scan(line, message)) continue;
    bag.write(scan_topic, ros::Time(1000.0 + line * kPeriod_s), message);
  }
}

}  // namespace ribbon_mapper
