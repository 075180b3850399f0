// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "modeler/scan/laser_beams.hpp"

namespace ribbon_mapper {

/// Writes scan lines to a file with every bit of them, for test/python/lines_file.py.
class LinesFile {
 public:
  /// Creates the file.
  explicit LinesFile(const std::filesystem::path& path) : file_(path, std::ios::binary) {
    if (!file_) throw std::runtime_error("cannot write " + path.string());
  }

  /// Appends a line.
  void add(const LaserBeams& beams, const LinePoses& poses) {
    write(std::int64_t{beams.stamp.count()});
    for (const double number : {beams.angle_min_rad, beams.angle_increment_rad,
                                beams.time_increment_s, beams.range_min_m, beams.range_max_m}) {
      write(number);
    }
    for (const Pose& pose : {poses.T_odom_base_first, poses.T_odom_base_last,
                             poses.T_base_laser_first, poses.T_base_laser_last, poses.T_map_base}) {
      for (Eigen::Index i = 0; i < 16; ++i) write(pose.matrix()(i / 4, i % 4));
    }
    write(std::int64_t{static_cast<std::int64_t>(beams.ranges_m.size())});
    for (const float range_m : beams.ranges_m) write(range_m);
  }

 private:
  template <typename Number>
  void write(Number number) {
    file_.write(reinterpret_cast<const char*>(&number), sizeof number);
  }

  std::ofstream file_;
};

}  // namespace ribbon_mapper
