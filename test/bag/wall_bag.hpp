// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <filesystem>
#include <functional>
#include <string>

namespace ribbon_mapper {

/// A bag of a robot that stands 3 m before a wall and tilts its laser. Tests spoil it.
struct WallBag {
  int lines = 200;                              ///< number of scans, at 40 Hz
  std::string scan_topic = "/tilt_scan";        ///< of all scans
  std::string laser_frame = "laser_tilt_link";  ///< of all scans
  std::string slash;                            ///< prefix of all frames in tf
  double first_stamp_s = 1000.0;                ///< of scans and tf; recorded from 1000 s on
  double tilt_rad = 0.3;                        ///< amplitude; the period is 2 s
  bool with_tf = true;                          ///< has /tf
  bool with_static = true;                      ///< has /tf_static
  bool with_map = true;                         ///< has the frame map
  bool static_last = false;                     ///< /tf_static is recorded last
  double tf_gap_begin_s = -1.0;                 ///< /tf has a gap from here, after the first stamp
  double tf_gap_end_s = -1.0;                   ///< end of the gap
  std::string tf_space;       ///< prefix of the topics /tf and /tf_static: /robot1
  std::string late_frame;     ///< a moving child frame whose transforms are recorded late
  double late_s = 0.0;        ///< how late; negative: before their time
  bool is_compressed = true;  ///< by BZ2
  std::function<bool(int line, sensor_msgs::LaserScan& scan)>
      spoil_scan;                                              ///< returns false to leave it out
  std::function<void(tf2_msgs::TFMessage& message)> spoil_tf;  ///< changes each message

  std::function<void(tf2_msgs::TFMessage& message)> spoil_static;  ///< changes /tf_static

  /// Writes the bag.
  void write(const std::filesystem::path& file) const;

 private:
  double tilt_at(double seconds) const;
  sensor_msgs::LaserScan scan(int line) const;
  tf2_msgs::TFMessage tf(double seconds) const;
};

}  // namespace ribbon_mapper
