// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/tf_survey.hpp"

#include <algorithm>

#include "modeler/ros/bag_check/number_text.hpp"
#include "modeler/ros/messages/message_conversions.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kGapsOfLines = 4.0;  // interpolation is still good at half the rate of the lines
constexpr double kMinGap_s = 0.25;

}  // namespace

void TfSurvey::add(const tf2_msgs::TFMessage& message, bool is_static) {
  ++messages_;
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    const std::string parent = without_slash(transform.header.frame_id);
    const std::string child = without_slash(transform.child_frame_id);
    if (parent != transform.header.frame_id || child != transform.child_frame_id) ++with_slash_;
    Link& link = links_[child];
    link.parents.insert(parent);
    link.is_static |= is_static;
    const double stamp_s = transform.header.stamp.toSec();
    if (link.transforms++ == 0) {
      link.first_s = link.newest_s = stamp_s;
      continue;
    }
    if (stamp_s < link.newest_s) ++link.backwards;
    link.longest_gap_s = std::max(link.longest_gap_s, stamp_s - link.newest_s);
    link.newest_s = std::max(link.newest_s, stamp_s);
  }
}

void TfSurvey::report(const Frames& frames, double line_period_s, BagReport& report) const {
  if (messages_ == 0) {
    report.fault("there is no /tf: record it, else the poses of the laser are unknown");
    return;
  }
  if (with_slash_ > 0) {
    report.fact(counted(with_slash_, "transform") + " with a leading slash; it is stripped");
  }
  const bool any_static = std::any_of(links_.begin(), links_.end(),
                                      [](const auto& link) { return link.second.is_static; });
  if (!any_static) report.fact("there is no /tf_static");
  for (const std::string& frame : {frames.odom, frames.base}) {
    const auto link = links_.find(frame);
    if (link == links_.end()) continue;
    report.fact("the bag holds " + *link->second.parents.begin() + " -> " + frame + " (" +
                counted(link->second.transforms, "transform") +
                "): if a localisation runs during the replay, leave it out with tf_drop_frames");
  }
  report_links(line_period_s, report);
}

void TfSurvey::report_links(double line_period_s, BagReport& report) const {
  const double limit_s = std::max(kMinGap_s, kGapsOfLines * line_period_s);
  for (const auto& [child, link] : links_) {
    const std::string name = *link.parents.begin() + " -> " + child;
    if (link.parents.size() > 1) {
      report.warning("frame " + child + " has " + std::to_string(link.parents.size()) +
                     " parents in tf: two sources publish its pose");
    }
    if (link.backwards > link.transforms / 10) {
      report.warning("stamps of " + name + " go backwards " + std::to_string(link.backwards) +
                     " times: two sources, or time jumps");
    }
    if (!link.is_static && link.longest_gap_s > limit_s) {
      report.warning("tf has a gap of " + number(link.longest_gap_s, 2) + " s in " + name +
                     ", longer than " + number(kGapsOfLines, 0) +
                     " lines: poses in it are interpolated, and wrong if anything moved");
    }
  }
}

}  // namespace ribbon_mapper
