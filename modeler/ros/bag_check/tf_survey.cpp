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
constexpr double kLate_s = 0.5;  // live, lines wait; less is the way of a localisation
constexpr std::size_t kMaxNamed = 5;

using Links = std::map<std::string, LoggedLink>;

std::string name_of(const Links::value_type& link) {
  return shown(*link.second.parents.begin()) + " -> " + shown(link.first);
}

/// Returns the names of the links for which `is_such` holds, five at most.
template <typename Condition>
std::string names_of(const Links& links, const Condition& is_such) {
  std::string names;
  std::size_t count = 0;
  for (const auto& link : links) {
    if (!is_such(link.second)) continue;
    if (++count <= kMaxNamed) names += (count == 1 ? "" : ", ") + name_of(link);
  }
  return count > kMaxNamed ? names + ", ..." : names;
}

void report_frames(const BagLines& lines, BagReport& report) {
  const TransformLog& transforms = lines.transforms();
  const Links& links = transforms.links();
  report.fact("tf: " + transforms.tree().text(lines.laser_frame()));
  if (transforms.with_slash() > 0) {
    report.fact(counted(transforms.with_slash(), "transform") +
                " with a leading slash; it is stripped");
  }
  if (std::none_of(links.begin(), links.end(),
                   [](const auto& link) { return link.second.fixed > 0; })) {
    report.fact("there is no /tf_static");
  }
  for (const std::string& frame : {lines.frames().odom, lines.frames().base}) {
    const auto link = links.find(frame);
    if (link == links.end()) continue;
    const bool is_localisation = frame == lines.frames().odom;
    report.fact("the bag holds " + name_of(*link) + " (" +
                counted(link->second.moving + link->second.fixed, "transform") + ")" +
                (is_localisation ? ": if another localisation runs during the replay, leave it out "
                                   "with tf_drop_frames:=" +
                                       lines.frames().map
                                 : ""));
  }
}

void report_late(const Links& links, double scan_delay_s, BagReport& report) {
  for (const auto& link : links) {
    const double late_s = link.second.delay_s() - scan_delay_s;
    if (link.second.moving == 0 || late_s < kLate_s) continue;
    report.warning(name_of(link) + " was recorded " + number(late_s, 1) +
                   " s later than scans of its time. A bag does not mind; a live node needs a "
                   "~transform_timeout above that");
  }
}

void report_order(const Links& links, double line_period_s, BagReport& report) {
  const double limit_s = std::max(kMinGap_s, kGapsOfLines * line_period_s);
  for (const auto& link : links) {
    const LoggedLink& l = link.second;
    if (l.parents.size() > 1) {
      report.warning("frame " + shown(link.first) + " has " + std::to_string(l.parents.size()) +
                     " parents in tf: two sources publish its pose");
    }
    if (l.backwards > l.moving / 10) {
      report.warning("stamps of " + name_of(link) + " go backwards by more than a second for " +
                     counted(l.backwards, "transform") +
                     ", which are left out: two sources, or time jumps");
    }
    if (l.longest_gap_s > limit_s) {
      report.warning("tf has a gap of " + number(l.longest_gap_s, 2) + " s in " + name_of(link) +
                     ", longer than " + number(kGapsOfLines, 0) +
                     " lines: poses in it are interpolated, and wrong if anything moved");
    }
  }
}

}  // namespace

std::vector<std::string> transform_warnings(const TransformLog& transforms) {
  std::vector<std::string> warnings;
  const TransformCounts& counts = transforms.counts();
  const Links& links = transforms.links();
  if (counts.refused > 0) {
    warnings.push_back(counted(counts.refused, "transform") + " cannot be used, the last one " +
                       counts.defect);
  }
  if (counts.repeated > 0) {
    std::string text = counted(counts.repeated, "transform") +
                       (counts.repeated == 1 ? " repeats" : " repeat") +
                       " the stamp of one before, of " +
                       names_of(links, [](const LoggedLink& link) { return link.repeated > 0; }) +
                       "; the first counts";
    text += counts.differing == 0 ? ": is each recorded twice?"
                                  : ". " + std::to_string(counts.differing) +
                                        " of them say something else: two nodes publish one frame";
    warnings.push_back(text);
  }
  const auto is_both = [](const LoggedLink& link) { return link.fixed > 0 && link.moving > 0; };
  const std::string both = names_of(links, is_both);
  if (!both.empty())
    warnings.push_back("on /tf_static and on /tf: " + both + "; the moving one counts");
  return warnings;
}

void report_transforms(const BagLines& lines, const ScanSurvey& scans, BagReport& report) {
  const TransformLog& transforms = lines.transforms();
  for (const std::string& choice : lines.choices()) report.warning(choice);
  if (transforms.messages() == 0) {
    report.fault("there is no /tf: record it, else the poses of the laser are unknown");
    return;
  }
  report_frames(lines, report);
  for (const std::string& warning : transform_warnings(transforms)) report.warning(warning);
  report_late(transforms.links(), scans.median_delay_s(), report);
  report_order(transforms.links(), scans.median_period_s(), report);
}

}  // namespace ribbon_mapper
