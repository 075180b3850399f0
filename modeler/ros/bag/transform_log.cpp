// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag/transform_log.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modeler/ros/intake/clock_guard.hpp"
#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

const Time kJitter = from_seconds(kMinTimeJump_s);
constexpr std::size_t kMaxStray = 5;  // stamps of another clock, before a source is set

bool is_earlier(const LoggedTransform& a, const LoggedTransform& b) { return a.stamp < b.stamp; }

/// Returns whether two transforms agree to the micrometre.
bool is_same(const LoggedTransform& a, const LoggedTransform& b) {
  constexpr double kSame = 1e-6;
  double apart_m = 0.0, turn = 0.0;
  for (int i = 0; i < 3; ++i) apart_m += std::abs(a.translation[i] - b.translation[i]);
  for (int i = 0; i < 4; ++i) turn += a.rotation[i] * b.rotation[i];
  return a.parent == b.parent && apart_m < kSame && std::abs(turn) > 1.0 - kSame;
}

/// Leaves out what is stamped before a time jump, and a few stamps far ahead of all that follow.
/// Returns how many are left.
std::size_t without_jumps(std::vector<LoggedTransform>& transforms) {
  std::vector<LoggedTransform> kept;
  kept.reserve(transforms.size());
  Time newest{0};
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    const Time stamp = transforms[i].stamp;
    if (kept.empty() || stamp + kJitter >= newest) {
      newest = std::max(newest, stamp);
      kept.push_back(transforms[i]);
      continue;
    }
    std::size_t ahead = 0;
    while (ahead < kept.size() && ahead <= kMaxStray &&
           kept[kept.size() - 1 - ahead].stamp > stamp + kJitter) {
      ++ahead;
    }
    if (ahead > kMaxStray || transforms.size() - i <= kMaxStray) continue;
    kept.resize(kept.size() - ahead);
    kept.push_back(transforms[i]);
    newest = stamp;
  }
  transforms = std::move(kept);
  return transforms.size();
}

}  // namespace

void TransformLog::add(const tf2_msgs::TFMessage& message, bool is_static, Time recorded) {
  ++messages_;
  for (const geometry_msgs::TransformStamped& given : message.transforms) {
    if (drop_frames_.count(without_slash(given.header.frame_id)) != 0) continue;
    if (const auto defect = find_defect(given)) {
      ++counts_.refused;
      counts_.defect = link_text(given) + ": " + *defect;
      continue;
    }
    const geometry_msgs::TransformStamped clean = cleaned(given);
    const std::string &parent = clean.header.frame_id, &child = clean.child_frame_id;
    if (parent != given.header.frame_id || child != given.child_frame_id) ++with_slash_;
    LoggedLink& link = links_[child];
    link.parents.insert(parent);
    tree_.add(parent, child);
    if (is_static) {
      ++link.fixed;
      fixed_.push_back(clean);
    } else {
      ++link.moving;
      link.delay_sum_s += (recorded - time_of(clean.header.stamp)).count() * 1e-9;
      if (!is_full()) store(clean);
    }
  }
}

bool TransformLog::is_full() const { return stored_ >= max_transforms_; }

void TransformLog::forget_moving() {
  moving_.clear();
  stored_ = 0;
}

void TransformLog::add_again(const tf2_msgs::TFMessage& message,
                             const std::set<std::string>& children) {
  for (const geometry_msgs::TransformStamped& given : message.transforms) {
    if (drop_frames_.count(without_slash(given.header.frame_id)) != 0) continue;
    if (children.count(without_slash(given.child_frame_id)) == 0 || find_defect(given)) continue;
    store(cleaned(given));
  }
}

void TransformLog::store(const geometry_msgs::TransformStamped& transform) {
  const std::uint32_t parent = number_of(transform.header.frame_id);
  const std::uint32_t child = number_of(transform.child_frame_id);
  const auto& t = transform.transform.translation;
  const auto& q = transform.transform.rotation;
  moving_[child].push_back(
      {time_of(transform.header.stamp), parent, child, {t.x, t.y, t.z}, {q.x, q.y, q.z, q.w}});
  ++stored_;
}

void TransformLog::finish() {
  for (auto& [child, transforms] : moving_) {
    finish(transforms, links_.at(names_[child]));
    sorted_.insert(sorted_.end(), transforms.begin(), transforms.end());
    Transforms().swap(transforms);
  }
  moving_.clear();
  std::stable_sort(sorted_.begin(), sorted_.end(), is_earlier);
}

void TransformLog::finish(Transforms& transforms, LoggedLink& link) {
  link.backwards = transforms.size();
  link.backwards -= without_jumps(transforms);
  std::stable_sort(transforms.begin(), transforms.end(), is_earlier);
  Transforms once;
  once.reserve(transforms.size());
  for (const LoggedTransform& transform : transforms) {
    if (!once.empty() && once.back().stamp == transform.stamp) {
      ++link.repeated;
      if (!is_same(once.back(), transform)) ++link.differing;
      continue;
    }
    if (!once.empty()) {
      const double gap_s = to_seconds(transform.stamp - once.back().stamp);
      link.longest_gap_s = std::max(link.longest_gap_s, gap_s);
    }
    once.push_back(transform);
  }
  counts_.repeated += link.repeated, counts_.differing += link.differing;
  transforms = std::move(once);
}

void TransformLog::enter_fixed(tf2::BufferCore& buffer) {
  for (const geometry_msgs::TransformStamped& transform : fixed_) {
    if (links_.at(transform.child_frame_id).moving > 0) continue;
    enter_transform(transform, true, buffer, counts_);
  }
}

void TransformLog::enter(Time from, Time until, double cache_s, tf2::BufferCore& buffer) {
  // A line stamped beyond the end gets no pose, and must not cost the lines after it theirs.
  if (sorted_.empty() || until > sorted_.back().stamp + (until - from)) return;
  if (next_ > 0 && from < sorted_[next_ - 1].stamp - from_seconds(0.5 * cache_s)) {
    buffer.clear();  // static transforms are kept by tf2
    LoggedTransform begin;
    begin.stamp = from - from_seconds(0.5 * cache_s);
    next_ = static_cast<std::size_t>(
        std::lower_bound(sorted_.begin(), sorted_.end(), begin, is_earlier) - sorted_.begin());
  }
  for (; next_ < sorted_.size() && sorted_[next_].stamp <= until; ++next_) {
    enter_transform(message_of(sorted_[next_]), false, buffer, counts_);
  }
}

std::uint32_t TransformLog::number_of(const std::string& frame) {
  const auto [found, is_new] =
      numbers_.try_emplace(frame, static_cast<std::uint32_t>(names_.size()));
  if (is_new) names_.push_back(frame);
  return found->second;
}

geometry_msgs::TransformStamped TransformLog::message_of(const LoggedTransform& transform) const {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp_of(transform.stamp);
  message.header.frame_id = names_[transform.parent];
  message.child_frame_id = names_[transform.child];
  auto& t = message.transform.translation;
  auto& q = message.transform.rotation;
  t.x = transform.translation[0], t.y = transform.translation[1], t.z = transform.translation[2];
  q.x = transform.rotation[0], q.y = transform.rotation[1], q.z = transform.rotation[2];
  q.w = transform.rotation[3];
  return message;
}

}  // namespace ribbon_mapper
