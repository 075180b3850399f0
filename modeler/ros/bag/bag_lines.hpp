// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/LaserScan.h>
#include <tf2/buffer_core.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "modeler/ros/bag/bag_set.hpp"
#include "modeler/ros/bag/bag_topics.hpp"
#include "modeler/ros/bag/transform_log.hpp"
#include "modeler/ros/intake/frame_tree.hpp"
#include "modeler/ros/intake/line_intake.hpp"
#include "modeler/ros/intake/line_log.hpp"

namespace ribbon_mapper {

/// Settings for reading scan lines from bags.
struct BagOptions {
  std::string scan_topic;                ///< empty: see scan_topic_of()
  std::string tf_topic;                  ///< empty: see tf_topics_of()
  std::string odometry_topic;            ///< nav_msgs/Odometry that stands in for tf; empty: none
  IntakeOptions intake;                  ///< frames and times
  NamedFrames named_frames;              ///< those that tf lacks are chosen, see choose_frames()
  std::set<std::string> tf_drop_frames;  ///< see enter_transforms()
  /// If there are more, transforms are read twice, and only those on the way to the laser are kept.
  std::size_t max_transforms = 2'000'000;
  double tf_cache_s = 120.0;  ///< how far lookups in tf reach back
};

/// Reads the scan lines of bags with their poses from tf. Uses the intake of the node. Reads all
/// transforms first, so that it does not matter when they were recorded: a line gets the poses of
/// its time. Over a gap, poses are interpolated if it ends within
/// IntakeOptions::transform_timeout_s after the line.
class BagLines {
 public:
  /// Opens the bags and reads the transforms. `log` counts lines and drops; it must outlive this
  /// object. Throws std::runtime_error as BagSet, scan_topic_of() and tf_topics_of() do.
  BagLines(const std::vector<std::filesystem::path>& bags, const BagOptions& options, LineLog& log);
  ~BagLines();  ///< closes the bags

  /// Reads on and returns the next line; nothing at the end. Throws std::runtime_error if a bag is
  /// damaged.
  std::optional<ReadyLine> next();

  /// Returns the topic of the scans.
  const std::string& scan_topic() const { return scan_topic_; }
  /// Returns the number of scans in the bags.
  std::size_t line_count() const { return line_count_; }
  /// Returns the transforms.
  const TransformLog& transforms() const { return transforms_; }
  /// Returns the frames that are used.
  const Frames& frames() const { return options_.intake.frames; }
  /// Returns a sentence for each topic or frame that was chosen because the wanted one is missing,
  /// or that has to be named because there are several choices.
  const std::vector<std::string>& choices() const { return choices_; }
  /// Returns the frame of the scans.
  const std::string& laser_frame() const { return laser_frame_; }
  /// Returns tf around the newest line, back to BagOptions::tf_cache_s.
  const tf2::BufferCore& buffer() const { return tf_; }

 private:
  void read_transforms();
  void read_odometry();
  void read_again();
  void find_laser_frame();
  IntakeOptions with_frames_chosen();
  void enter_transforms_around(const sensor_msgs::LaserScan& scan);

  BagSet bags_;
  BagOptions options_;
  std::string scan_topic_;
  TfTopics tf_topics_;
  std::string laser_frame_;
  std::vector<std::string> choices_;
  TransformLog transforms_;
  LineIntake intake_;
  tf2::BufferCore tf_;
  std::size_t line_count_ = 0;
  std::unique_ptr<rosbag::View> scans_;
  rosbag::View::iterator at_;
};

}  // namespace ribbon_mapper
