// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/bag_check.hpp"

#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <stdexcept>

#include "modeler/ros/bag_check/number_text.hpp"
#include "modeler/ros/bag_check/scan_survey.hpp"
#include "modeler/ros/bag_check/tf_survey.hpp"
#include "modeler/ros/bag_check/tilt_survey.hpp"

namespace ribbon_mapper {
namespace {

void list_topics(const std::vector<BagTopic>& topics, BagReport& report) {
  for (const BagTopic& topic : topics) {
    report.fact(topic.name + ": " + counted(topic.messages, "message") + " of " + topic.type);
  }
}

void survey_messages(const BagSet& bags, const std::string& scan_topic, ScanSurvey& scans,
                     TfSurvey& transforms) {
  bags.read({scan_topic, "/tf", "tf", "/tf_static", "tf_static"},
            [&](const rosbag::MessageInstance& message) {
              if (const auto scan = message.instantiate<sensor_msgs::LaserScan>()) {
                scans.add(*scan, message.getTime());
              } else if (const auto tf = message.instantiate<tf2_msgs::TFMessage>()) {
                const std::string& topic = message.getTopic();
                transforms.add(*tf, topic.find("static") != std::string::npos);
              }
              return true;
            });
}

void report_drops(const LineLog& log, BagReport& report) {
  const std::size_t dropped = log.dropped_lines();
  if (dropped == 0) {
    report.fact("tf has the pose of every line");
    return;
  }
  for (const auto& [reason, count] : log.dropped_by_reason()) {
    const std::string text = counted(count, "line") + " of " + std::to_string(log.lines()) +
                             " would be dropped: " + reason;
    2 * dropped > log.lines() ? report.fault(text) : report.warning(text);
  }
}

void check(const std::vector<std::filesystem::path>& files, const BagOptions& options,
           BagReport& report) {
  const BagSet bags(files);
  list_topics(bags.topics(), report);
  const std::string scan_topic = scan_topic_of(bags.topics(), options.scan_topic);
  ScanSurvey scans;
  TfSurvey transforms;
  survey_messages(bags, scan_topic, scans, transforms);
  scans.report(report);
  transforms.report(options.intake.frames, scans.median_period_s(), report);

  LineLog log;
  BagLines lines(files, options, log);
  TiltSurvey tilt;
  while (const std::optional<ReadyLine> line = lines.next()) tilt.add(line->beams, line->poses);
  report_drops(log, report);
  if (lines.refused_transforms() > 0) {
    report.warning(counted(lines.refused_transforms(), "transform") +
                   " cannot be used: not finite, no unit quaternion, or a frame in itself");
  }
  tilt.report(scans, report);
}

}  // namespace

BagReport check_bags(const std::vector<std::filesystem::path>& files, const BagOptions& options) {
  BagReport report;
  try {
    check(files, options, report);
  } catch (const std::runtime_error& error) {
    report.fault(error.what());
  }
  return report;
}

}  // namespace ribbon_mapper
