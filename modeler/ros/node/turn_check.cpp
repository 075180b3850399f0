// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/node/turn_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ribbon_mapper {
namespace {

constexpr Time kStep = std::chrono::milliseconds(100);
constexpr Time kMaxGap = std::chrono::seconds(1);
constexpr Time kMaxStretch = std::chrono::seconds(60);  // beyond it, even good odometry drifts
constexpr float kStretch_rad = 10.0F * static_cast<float>(M_PI) / 180.0F;
constexpr float kMinTotal_rad = 3.0F * kStretch_rad;
/// Odometry of wheels that slip is off by a quarter of a turn at most. Wrong conventions are off by
/// all of it (no rotation), 1.4 times (another axis) or twice (another direction).
constexpr float kContradiction = 0.5F;

}  // namespace

void TurnCheck::add(Time stamp, const Pose& T_odom_base) {
  if (!headings_.empty() && stamp < headings_.back().stamp + kStep) return;
  headings_.push_back({stamp, Eigen::Quaterniond(T_odom_base.linear()).cast<float>()});
}

std::optional<Eigen::Quaternionf> TurnCheck::heading_at(Time stamp) const {
  const auto after =
      std::lower_bound(headings_.begin(), headings_.end(), stamp,
                       [](const Heading& heading, Time time) { return heading.stamp < time; });
  if (after == headings_.end()) return std::nullopt;
  if (after->stamp == stamp) return after->R_odom_base;
  if (after == headings_.begin()) return std::nullopt;
  const Heading& before = after[-1];
  if (after->stamp - before.stamp > kMaxGap) return std::nullopt;
  const double fraction =
      to_seconds(stamp - before.stamp) / to_seconds(after->stamp - before.stamp);
  return before.R_odom_base.slerp(static_cast<float>(fraction), after->R_odom_base);
}

std::optional<std::string> TurnCheck::contradiction(
    const std::vector<StampedPose>& trajectory) const {
  std::optional<Heading> odom_begin;
  Eigen::Quaternionf begin = Eigen::Quaternionf::Identity();
  float apart_rad = 0.0F, odom_rad = 0.0F, trajectory_rad = 0.0F, total_rad = 0.0F;
  for (const StampedPose& pose : trajectory) {
    const auto odom = heading_at(pose.stamp);
    if (!odom) continue;
    const Eigen::Quaternionf now = Eigen::Quaterniond(pose.T_map_base.linear()).cast<float>();
    if (odom_begin && pose.stamp - odom_begin->stamp <= kMaxStretch) {
      const Eigen::Quaternionf a = odom_begin->R_odom_base.conjugate() * *odom;
      const Eigen::Quaternionf b = begin.conjugate() * now;
      const auto unit = Eigen::Quaternionf::Identity();
      const float a_rad = unit.angularDistance(a), b_rad = unit.angularDistance(b);
      if (std::max(a_rad, b_rad) < kStretch_rad) continue;
      odom_rad += a_rad, trajectory_rad += b_rad;
      total_rad += std::max(a_rad, b_rad);
      apart_rad += a.angularDistance(b);
    }
    odom_begin = Heading{pose.stamp, *odom};
    begin = now;
  }
  if (total_rad < kMinTotal_rad || apart_rad < kContradiction * total_rad) return std::nullopt;
  const auto degrees = [](float angle_rad) {
    return static_cast<double>(angle_rad) * 180.0 / M_PI;
  };
  char text[400];
  std::snprintf(
      text, sizeof text,
      "the turns of the trajectory contradict the odometry: it turns by %.0f degrees in "
      "all, odometry by %.0f, and they differ by %.0f. Are its quaternions in the order x "
      "y z w, and its poses those of the base, not of a sensor?",
      degrees(trajectory_rad), degrees(odom_rad), degrees(apart_rad));
  return text;
}

}  // namespace ribbon_mapper
