// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "modeler/ros/bag/bag_lines.hpp"
#include "slam/base_laser/level_odometry.hpp"

namespace ribbon_mapper {

/// What became of the scans of a level laser.
struct BaseScanFigures {
  std::string topic;                           ///< of the scans
  std::size_t scans = 0;                       ///< that were read
  std::size_t matched = 0;                     ///< that refined the odometry
  std::map<std::string, std::size_t> dropped;  ///< by reason
};

/// Reads the scans of a level laser on the base beside the lines of a tilting one, and refines the
/// odometry by them.
class BaseScans {
 public:
  /// Opens the bags. `options` are those of the tilting laser, whose topic is replaced. Throws
  /// std::runtime_error as BagLines does.
  BaseScans(const std::vector<std::filesystem::path>& bags, BagOptions options,
            const std::string& topic);

  /// Takes all scans up to the first one after a time, which a line of this time is placed by.
  void take_until(Time stamp);

  /// Returns the odometry that the scans taken so far refine.
  const slam::LevelOdometry& odometry() const { return odometry_; }

  /// Returns what became of the scans. Throws std::runtime_error with the reasons if most could not
  /// be used: a tilting laser is level now and then.
  BaseScanFigures figures() const;

 private:
  LineLog log_;
  BagLines lines_;
  slam::LevelOdometry odometry_{slam::LevelOdometryConfig()};
  Time newest_{0};  // stamp of the last scan that was read
  bool is_at_end_ = false;
};

}  // namespace ribbon_mapper
