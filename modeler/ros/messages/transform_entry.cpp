// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/messages/transform_entry.hpp"

#include <console_bridge/console.h>
#include <tf2/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>

#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

/// QUATERNION_NORMALIZATION_TOLERANCE of tf2: the square of the length may be off by this.
constexpr double kMaxSquareError = 10e-3;
/// A quaternion of 32-bit numbers is off by less. It stays as it is, to the last bit.
constexpr double kRoundingError = 1e-6;
/// tf2 adds the time that it keeps to a stamp, and throws on overflow.
constexpr std::uint32_t kLatestStamp_s = 0xffffffffu - 7200u;
constexpr double kSame = 1e-6;  // of metres, and of elements of a quaternion

/// Silences tf2, which prints a line for each transform that it does not take.
class QuietTf2 {
 public:
  QuietTf2() : level_(console_bridge::getLogLevel()) {
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  }
  ~QuietTf2() { console_bridge::setLogLevel(level_); }
  QuietTf2(const QuietTf2&) = delete;
  QuietTf2& operator=(const QuietTf2&) = delete;

 private:
  console_bridge::LogLevel level_;
};

double square_of(const geometry_msgs::Quaternion& q) {
  return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
}

bool is_same(const geometry_msgs::Transform& a, const geometry_msgs::Transform& b) {
  const auto &p = a.translation, &q = b.translation;
  const auto &r = a.rotation, &s = b.rotation;
  const double turn = std::abs(r.w * s.w + r.x * s.x + r.y * s.y + r.z * s.z);  // -q is q
  return std::abs(p.x - q.x) + std::abs(p.y - q.y) + std::abs(p.z - q.z) < kSame &&
         turn > 1.0 - kSame;
}

/// Counts a transform that tf2 has refused though it is usable: repeated, or too old.
void count_refused(const geometry_msgs::TransformStamped& transform, tf2::BufferCore& buffer,
                   TransformCounts& counts) {
  try {
    const geometry_msgs::TransformStamped first = buffer.lookupTransform(
        transform.header.frame_id, transform.child_frame_id, transform.header.stamp);
    if (!is_same(first.transform, transform.transform)) ++counts.differing;
    ++counts.repeated;
  } catch (const tf2::ExtrapolationException&) {
    ++counts.refused;
    counts.defect = link_text(transform) + ": it is older than tf is kept";
  } catch (const std::runtime_error&) {  // the first has another parent
    ++counts.repeated, ++counts.differing;
  }
}

}  // namespace

TransformCounts& TransformCounts::operator+=(const TransformCounts& other) {
  refused += other.refused, repeated += other.repeated, differing += other.differing;
  if (!other.defect.empty()) defect = other.defect;
  return *this;
}

std::optional<std::string> find_defect(const geometry_msgs::TransformStamped& transform) {
  const geometry_msgs::Vector3& t = transform.transform.translation;
  const std::string parent = without_slash(transform.header.frame_id);
  const std::string child = without_slash(transform.child_frame_id);
  if (parent.empty() || child.empty()) return "a frame has no name";
  if (std::max(parent.size(), child.size()) > kMaxFrameName)
    return "the name of a frame is too long";
  if (parent == child) return "it is a frame in itself";
  if (transform.header.stamp.sec > kLatestStamp_s) return "its stamp is beyond what tf can keep";
  if (!std::isfinite(t.x + t.y + t.z)) return "its translation is not finite";
  const double square = square_of(transform.transform.rotation);
  if (std::abs(square - 1.0) < kMaxSquareError) return std::nullopt;
  char text[100];
  std::snprintf(text, sizeof text, "its quaternion has length %.4g, tf2 takes 0.995 to 1.005",
                std::sqrt(square));
  return text;
}

geometry_msgs::TransformStamped cleaned(const geometry_msgs::TransformStamped& transform) {
  geometry_msgs::TransformStamped clean = transform;
  clean.header.frame_id = without_slash(transform.header.frame_id);
  clean.child_frame_id = without_slash(transform.child_frame_id);
  geometry_msgs::Quaternion& q = clean.transform.rotation;
  const double square = square_of(q);
  if (std::abs(square - 1.0) < kRoundingError) return clean;
  const double length = std::sqrt(square);
  q.w /= length, q.x /= length, q.y /= length, q.z /= length;
  return clean;
}

void enter_transform(const geometry_msgs::TransformStamped& transform, bool is_static,
                     tf2::BufferCore& buffer, TransformCounts& counts) {
  const QuietTf2 quiet;
  try {
    if (!buffer.setTransform(transform, "tf", is_static)) count_refused(transform, buffer, counts);
  } catch (const std::runtime_error& error) {  // of tf2, or of ROS
    ++counts.refused;
    counts.defect = link_text(transform) + ": " + shown(error.what(), 300);
  }
}

TransformCounts enter_transforms(const tf2_msgs::TFMessage& message, bool is_static,
                                 const std::set<std::string>& drop_frames,
                                 tf2::BufferCore& buffer) {
  TransformCounts counts;
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    if (drop_frames.count(without_slash(transform.header.frame_id)) != 0) continue;
    if (const auto defect = find_defect(transform)) {
      ++counts.refused;
      counts.defect = link_text(transform) + ": " + *defect;
    } else {
      enter_transform(cleaned(transform), is_static, buffer, counts);
    }
  }
  return counts;
}

std::string link_text(const geometry_msgs::TransformStamped& transform) {
  return shown(without_slash(transform.header.frame_id)) + " -> " +
         shown(without_slash(transform.child_frame_id));
}

std::set<std::string> frames_from(const std::string& list) {
  std::set<std::string> frames;
  for (std::size_t begin = 0; begin < list.size();) {
    begin = list.find_first_not_of(" ,", begin);
    if (begin == std::string::npos) break;
    const std::size_t end = std::min(list.find_first_of(" ,", begin), list.size());
    frames.insert(without_slash(list.substr(begin, end - begin)));
    begin = end;
  }
  return frames;
}

}  // namespace ribbon_mapper
