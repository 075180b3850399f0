// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/bag_check.hpp"

#include <sensor_msgs/LaserScan.h>

#include <stdexcept>

#include "modeler/ros/bag/bag_message.hpp"
#include "modeler/ros/bag_check/number_text.hpp"
#include "modeler/ros/bag_check/scan_survey.hpp"
#include "modeler/ros/bag_check/tf_survey.hpp"
#include "modeler/ros/bag_check/tilt_survey.hpp"
#include "modeler/ros/intake/model_doubts.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/node/model_keeper.hpp"

namespace ribbon_mapper {
namespace {

void list_topics(const std::vector<BagTopic>& topics, BagReport& report) {
  for (const BagTopic& topic : topics) {
    report.fact(shown(topic.name) + ": " + counted(topic.messages, "message") + " of " +
                shown(topic.type));
  }
}

void survey_scans(const BagSet& bags, const std::string& scan_topic, ScanSurvey& scans) {
  bags.read({scan_topic}, [&](const rosbag::MessageInstance& message) {
    if (const auto scan = message_of<sensor_msgs::LaserScan>(message))
      scans.add(*scan, message.getTime());
    return true;
  });
}

void report_drops(const LineLog& log, BagReport& report) {
  const std::size_t dropped = log.dropped_lines();
  if (dropped == 0) report.fact("tf has the pose of every line");
  for (const auto& [reason, count] : log.dropped_by_reason()) {
    const std::string text = counted(count, "line") + " of " + std::to_string(log.lines()) +
                             " would be dropped: " + reason;
    dropped == log.lines() ? report.fault(text) : report.warning(text);
  }
  if (dropped > 0) report.fact("the last of these lines: " + log.newest_drop());
  if (log.lost() > 0) {
    report.warning(counted(log.lost(), "line") +
                   " were lost before they were recorded: header.seq has gaps");
  }
}

/// Adds what became of the lines. A model without ribbons is a fault, and one with planes shows
/// that no fault is one.
void report_model(ModelKeeper& keeper, const AssemblyConfig& config, BagReport& report) {
  const ModelStatistics statistics = keeper.modeler().statistics();
  const std::size_t planes = keeper.planes().size();
  if (planes > 0) {
    report.fact("the lines give " + counted(statistics.ribbons, "ribbon") + " and " +
                counted(planes, "plane") + " with the poses as recorded");
    report.turn_faults_into_warnings();
    return;
  }
  const std::string why = "no plane: " + why_no_planes(keeper.log(), statistics, config);
  statistics.ribbons == 0 ? report.fault(why) : report.warning(why);
}

void check(const std::vector<std::filesystem::path>& files, const BagOptions& options,
           const ModelerConfig& preset, BagReport& report) {
  const BagSet bags(files);
  list_topics(bags.topics(), report);
  ScanSurvey scans(preset.scan);
  ModelKeeper keeper(preset);
  BagLines lines(files, options, keeper.log());
  survey_scans(bags, lines.scan_topic(), scans);
  scans.report(report);
  report_transforms(lines, scans, report);

  TiltSurvey tilt;
  while (const std::optional<ReadyLine> line = lines.next()) {
    tilt.add(line->beams, line->poses);
    keeper.add(*line);
  }
  report_drops(keeper.log(), report);
  tilt.report(scans, preset, report);
  report_model(keeper, preset.assembly, report);
}

}  // namespace

BagReport check_bags(const std::vector<std::filesystem::path>& files, const BagOptions& options,
                     const ModelerConfig& preset) {
  BagReport report;
  try {
    check(files, options, preset, report);
  } catch (const std::runtime_error& error) {
    report.fault(error.what());
  }
  return report;
}

}  // namespace ribbon_mapper
