// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2/buffer_core.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "modeler/ros/bag/bag_set.hpp"
#include "modeler/ros/intake/line_intake.hpp"
#include "modeler/ros/intake/line_log.hpp"

namespace ribbon_mapper {

struct BagOptions {
  std::string scan_topic;  ///< empty: see scan_topic_of()
  IntakeOptions intake;
  std::set<std::string> tf_drop_frames;  ///< see enter_transforms()
  double tf_cache_s = 120.0;
};

/// The topic of the tilting laser: `wanted`, with or without its leading slash; if that is empty,
/// the only topic of LaserScans, or tilt_scan among several. Throws std::runtime_error that lists
/// the topics with scans if there is none, if it is not clear which, or if it carries another type.
std::string scan_topic_of(const std::vector<BagTopic>& topics, const std::string& wanted);

/// The scan lines of bags with the poses that tf has for them, as the node would take them: the
/// same intake, but by the clock of the recording. All of /tf_static is read first, for a part of a
/// longer recording may have it late.
class BagLines {
 public:
  /// `log` counts lines and drops; it must outlive this. Throws std::runtime_error as BagSet and
  /// scan_topic_of() do.
  BagLines(const std::vector<std::filesystem::path>& bags, const BagOptions& options, LineLog& log);
  ~BagLines();

  /// Throws std::runtime_error if a bag is damaged.
  std::optional<ReadyLine> next();

  const std::string& scan_topic() const { return scan_topic_; }
  std::size_t line_count() const { return line_count_; }       ///< scans in the bags
  std::size_t refused_transforms() const { return refused_; }  ///< not usable, left out
  const tf2::BufferCore& tf() const { return tf_; }

 private:
  void take(const rosbag::MessageInstance& message);

  BagSet bags_;
  BagOptions options_;
  LineIntake intake_;
  tf2::BufferCore tf_;
  std::string scan_topic_;
  std::size_t line_count_ = 0, refused_ = 0;
  std::unique_ptr<rosbag::View> messages_;
  rosbag::View::iterator at_;
  Moment now_;
};

}  // namespace ribbon_mapper
