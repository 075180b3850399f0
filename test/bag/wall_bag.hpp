// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <filesystem>
#include <functional>
#include <string>

namespace ribbon_mapper {

/// A robot that stands 3 m before a wall and tilts its laser, as a bag: what the tests spoil.
struct WallBag {
  int lines = 200;
  std::string scan_topic = "/tilt_scan";
  std::string laser_frame = "laser_tilt_link";
  std::string slash;  ///< before all frames in tf
  double first_stamp_s = 1000.0;
  double tilt_rad = 0.3;  ///< to either side, period 2 s
  bool with_tf = true, with_static = true, with_map = true;
  bool static_last = false;
  double tf_gap_begin_s = -1.0,
         tf_gap_end_s = -1.0;  ///< no /tf in between, from the first stamp on
  bool is_compressed = true;
  std::function<bool(int line, sensor_msgs::LaserScan& scan)> spoil_scan;  ///< false: leave it out
  std::function<void(tf2_msgs::TFMessage& message)> spoil_tf;

  void write(const std::filesystem::path& file) const;

 private:
  double tilt_at(double seconds) const;
  sensor_msgs::LaserScan scan(int line) const;
  tf2_msgs::TFMessage tf(double seconds) const;
};

}  // namespace ribbon_mapper
