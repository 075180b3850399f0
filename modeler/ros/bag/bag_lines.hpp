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

/// Settings for reading scan lines from bags.
struct BagOptions {
  std::string scan_topic;                ///< empty: see scan_topic_of()
  IntakeOptions intake;                  ///< frames and times
  std::set<std::string> tf_drop_frames;  ///< see enter_transforms()
  double tf_cache_s = 120.0;             ///< how far lookups in tf reach back
};

/// Returns the topic of the tilting laser: `wanted`, with or without its leading slash. If `wanted`
/// is empty, returns the only topic with scans, or tilt_scan among several. Throws
/// std::runtime_error that lists the topics with scans if there is none, if the choice is not
/// clear, or if the topic carries another type.
std::string scan_topic_of(const std::vector<BagTopic>& topics, const std::string& wanted);

/// Reads the scan lines of bags with their poses from tf. Uses the intake of the node, with the
/// clock of the recording. Reads all of /tf_static first, because a part of a longer recording may
/// have it late.
class BagLines {
 public:
  /// Opens the bags. `log` counts lines and drops; it must outlive this object. Throws
  /// std::runtime_error as BagSet and scan_topic_of() do.
  BagLines(const std::vector<std::filesystem::path>& bags, const BagOptions& options, LineLog& log);
  ~BagLines();  ///< closes the bags

  /// Reads on and returns the next line; nothing at the end. Throws std::runtime_error if a bag is
  /// damaged.
  std::optional<ReadyLine> next();

  /// Returns the topic of the scans.
  const std::string& scan_topic() const { return scan_topic_; }
  /// Returns the number of scans in the bags.
  std::size_t line_count() const { return line_count_; }
  /// Returns the transforms read so far, back to BagOptions::tf_cache_s.
  const tf2::BufferCore& transforms() const { return tf_; }
  /// Returns the number of unusable transforms so far.
  std::size_t refused_transforms() const { return refused_; }

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
