// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/messages/message_conversions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ribbon_mapper {
namespace {

constexpr double kMaxDuration_s = 10.0;  // of a scan
/// Most beams that angle_max may count too many, per range. With more, ranges were rather cropped,
/// and nobody knows on which side.
constexpr double kMaxMissing = 1.0;
/// ros::Time has 32 bits for seconds and throws on overflow.
constexpr std::uint32_t kLatestStamp_s = 0xffffffffu - 60u;

template <typename Vector, typename Quaternion>
Pose rigid(const Vector& translation, const Quaternion& rotation) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond(rotation.w, rotation.x, rotation.y, rotation.z)
                      .normalized()
                      .toRotationMatrix();
  pose.translation() << translation.x, translation.y, translation.z;
  return pose;
}

template <typename Message>
Message xyz(const Eigen::Vector3d& from) {
  Message message;
  message.x = from.x(), message.y = from.y(), message.z = from.z();
  return message;
}

geometry_msgs::Quaternion quaternion_message(const Pose& pose) {
  const Eigen::Quaterniond rotation(pose.linear());
  geometry_msgs::Quaternion message;
  message.w = rotation.w(), message.x = rotation.x();
  message.y = rotation.y(), message.z = rotation.z();
  return message;
}

[[noreturn]] void refuse(std::size_t index, const std::string& why) {
  throw std::invalid_argument("pose " + std::to_string(index) + " " + why);
}

void require_frame(const std::string& given, const std::string& frame) {
  if (without_slash(given) == frame) return;
  throw std::invalid_argument("it is in frame '" + shown(given) + "', must be in '" + shown(frame) +
                              "'");
}

}  // namespace

Time time_of(const ros::Time& stamp) {
  return std::chrono::seconds(stamp.sec) + std::chrono::nanoseconds(stamp.nsec);
}

ros::Time stamp_of(Time time) {
  ros::Time stamp;
  stamp.fromNSec(static_cast<std::uint64_t>(time.count()));
  return stamp;
}

std::string without_slash(const std::string& frame) {
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

std::string shown(const std::string& text, std::size_t max_length) {
  std::string cut = text.substr(0, max_length);
  for (char& c : cut) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  return text.size() > max_length ? cut + "..." : cut;
}

Pose pose_of(const geometry_msgs::Transform& transform) {
  return rigid(transform.translation, transform.rotation);
}

std::optional<Pose> pose_of(const geometry_msgs::Pose& message) {
  const geometry_msgs::Quaternion& q = message.orientation;
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (!(std::abs(length - 1.0) < 0.01)) return std::nullopt;
  const Pose pose = rigid(message.position, q);
  if (!is_valid(pose)) return std::nullopt;
  return pose;
}

geometry_msgs::Pose pose_message(const Pose& pose) {
  geometry_msgs::Pose message;
  message.position = point_message(pose.translation());
  message.orientation = quaternion_message(pose);
  return message;
}

geometry_msgs::Transform transform_message(const Pose& pose) {
  geometry_msgs::Transform message;
  message.translation = vector_message(pose.translation());
  message.rotation = quaternion_message(pose);
  return message;
}

geometry_msgs::Point point_message(const Eigen::Vector3d& point) {
  return xyz<geometry_msgs::Point>(point);
}

geometry_msgs::Vector3 vector_message(const Eigen::Vector3d& vector) {
  return xyz<geometry_msgs::Vector3>(vector);
}

std::optional<std::string> find_defect(const sensor_msgs::LaserScan& scan) {
  if (scan.header.stamp.isZero()) return "stamp is zero";
  if (scan.header.stamp.sec > kLatestStamp_s) return "stamp is beyond what tf can look up";
  if (without_slash(scan.header.frame_id).empty()) return "frame is empty";
  if (scan.header.frame_id.size() > kMaxFrameName) return "name of its frame is too long";
  if (scan.ranges.empty()) return "no ranges";
  const double count = static_cast<double>(scan.ranges.size());
  const double missing = missing_beams(scan);
  if (!(missing >= -1.5 && missing <= std::max(1.5, kMaxMissing * count))) {
    return "number of ranges does not fit the angles";
  }
  const double duration_s = scan.time_increment * (count - 1.0);
  if (!(duration_s >= 0.0 && duration_s < kMaxDuration_s)) return "time_increment is out of range";
  return std::nullopt;
}

double missing_beams(const sensor_msgs::LaserScan& scan) {
  const double steps =
      (scan.angle_max - scan.angle_min) / static_cast<double>(scan.angle_increment);
  return steps + 1.0 - static_cast<double>(scan.ranges.size());
}

LaserBeams beams_of(const sensor_msgs::LaserScan& scan) {
  const double range_max_m =
      scan.range_max == 0.0F ? std::numeric_limits<double>::infinity() : scan.range_max;
  return {time_of(scan.header.stamp),
          scan.angle_min,
          scan.angle_increment,
          scan.time_increment,
          scan.range_min,
          range_max_m,
          scan.ranges};
}

nav_msgs::Path path_message(const std::vector<StampedPose>& trajectory, const std::string& frame,
                            Time stamp) {
  nav_msgs::Path path;
  path.header.frame_id = frame;
  path.header.stamp = stamp_of(stamp);
  path.poses.resize(trajectory.size());
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    path.poses[i].header.frame_id = frame;
    path.poses[i].header.stamp = stamp_of(trajectory[i].stamp);
    path.poses[i].pose = pose_message(trajectory[i].T_map_base);
  }
  return path;
}

std::vector<StampedPose> trajectory_of(const nav_msgs::Path& path, const std::string& frame) {
  if (path.poses.empty()) throw std::invalid_argument("it is empty");
  require_frame(path.header.frame_id, frame);
  std::vector<StampedPose> trajectory;
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    const geometry_msgs::PoseStamped& message = path.poses[i];
    if (!message.header.frame_id.empty()) require_frame(message.header.frame_id, frame);
    const std::optional<Pose> pose = pose_of(message.pose);
    if (!pose) refuse(i, "is not finite, lies beyond 1e9 m, or its quaternion is not of length 1");
    const Time stamp = time_of(message.header.stamp);
    if (i > 0 && stamp <= trajectory.back().stamp) {
      refuse(i, path.poses.front().header.stamp == path.poses.back().header.stamp
                    ? "is not later than the one before: all poses carry one stamp, as those of "
                      "RTAB-Map's mapPath do; slam_adapter takes its mapData and mapGraph instead"
                    : "is not later than the one before: each pose needs its own stamp, in order");
    }
    trajectory.push_back({stamp, *pose});
  }
  return trajectory;
}

}  // namespace ribbon_mapper
