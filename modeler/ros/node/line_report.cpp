// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/node/line_report.hpp"

#include <ros/console.h>

#include <utility>

namespace ribbon_mapper {

using diagnostic_msgs::DiagnosticStatus;

void LineReport::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const Counts now = counts();
  const Counts before = std::exchange(diagnosed_, now);
  if (now.lines == 0) {
    status.summary(DiagnosticStatus::WARN, "no scan on " + scan_topic_ + " since the model began");
  } else if (now.dropped > before.dropped) {
    status.summary(DiagnosticStatus::WARN, "lines are dropped");
  } else if (now.lost > before.lost) {
    status.summary(DiagnosticStatus::WARN, "lines are lost before they come here");
  } else if (!intake_.waits_for().empty() && now.lines == before.lines) {
    status.summary(DiagnosticStatus::WARN, "waiting: " + intake_.waits_for());
  } else {
    status.summary(DiagnosticStatus::OK, now.lines > before.lines ? "receiving" : "no new lines");
  }
  status.add("lines in", now.lines);
  status.add("lines waiting for tf", intake_.waiting());
  status.add("lines dropped", now.dropped);
  status.add("lines lost before they came (header.seq)", now.lost);
  status.add("gaps between lines", now.gaps);
  status.addf("time without lines in gaps [s]", "%.1f", log_.silent_s());
  const TransformCounts& transforms = tf_.counts();
  status.add("transforms repeated", transforms.repeated);
  status.add("transforms not usable", transforms.refused);
  for (const auto& [reason, count] : log_.dropped_by_reason())
    status.add("dropped: " + reason, count);
  for (const auto& [outcome, count] : log_.handled_by_outcome()) status.add(outcome, count);
}

void LineReport::warn() {
  const Counts now = counts();
  const Counts before = std::exchange(warned_, now);
  if (now.dropped != before.dropped) {
    ROS_WARN("A line is dropped: %s. %zu dropped so far%s", log_.newest_drop().c_str(), now.dropped,
             watch_.frames_advice(intake_, tf_).c_str());
    const std::string lateness = watch_.lateness(intake_, tf_);
    if (!lateness.empty()) ROS_WARN("%s", lateness.c_str());
  }
  if (now.lost != before.lost) {
    ROS_WARN(
        "Lines are lost before they come here: header.seq has gaps. %zu lost so far. Did this "
        "node or its computer stall, or is the network too slow?",
        now.lost);
  }
  if (now.gaps != before.gaps) {
    ROS_WARN(
        "No lines for %.1f s in %zu gaps so far, by their stamps: the laser was silent, or "
        "lines were lost.",
        log_.silent_s(), now.gaps);
  }
}

}  // namespace ribbon_mapper
