// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "modeler/geometry/time.hpp"
#include "slam/level/final_matching.hpp"
#include "slam/level/level_tracker.hpp"
#include "slam/level/loop_finder.hpp"
#include "slam/level/pose_graph.hpp"
#include "slam/matching/level_scan.hpp"

namespace ribbon_mapper::slam {

/// Settings of the SLAM for one level laser.
struct LevelSlamConfig {
  LevelScanConfig scan;                ///< see there
  TrackerConfig tracker;               ///< see there
  PlanarOdometryNoiseConfig odometry;  ///< see there
  MatchConfig match;                   ///< see there
  LoopConfig loop;                     ///< see there
  FinalMatchConfig final_match;        ///< see there
};

/// A pose of the base in map with its time.
struct StampedPlanarPose {
  Time stamp{0};          ///< of the scan
  PlanarPose T_map_base;  ///< estimated
};

/// What came of a log.
struct LevelSlamResult {
  std::vector<StampedPlanarPose> trajectory;  ///< one per scan, in order
  std::vector<Loop> loops;                    ///< all that were judged
  std::vector<Time> keyframe_stamps;          ///< by keyframe
};

/// Estimates the trajectory of a robot from a level laser and odometry. The first scan is the
/// origin of map. Scans are tracked as they come, and loops are closed on the way; in the end every
/// scan is matched again. It has no clock and no random numbers: same input, same result.
class LevelSlam {
 public:
  /// Creates an empty log.
  explicit LevelSlam(const LevelSlamConfig& config);

  /// Adds a scan with the pose of odometry at its stamp. Throws std::invalid_argument if the stamp
  /// is not later than the one before, or a number is not finite; nothing is changed then.
  void add(const LevelScan& scan, const PlanarPose& T_odom_base);

  /// Returns the result. Without a scan, it is empty.
  LevelSlamResult finish();

  /// Returns the tracker.
  const LevelTracker& tracker() const { return tracker_; }
  /// Returns the finder of loops.
  const LoopFinder& loop_finder() const { return loops_; }
  /// Returns the number of scans.
  std::size_t scan_count() const { return scans_.size(); }

 private:
  void add_to_graph();
  void close_loops();
  std::vector<Loop> settle();

  LevelSlamConfig config_;
  LevelTracker tracker_;
  LoopFinder loops_;
  PoseGraph graph_;
  std::vector<ScanToPlace> scans_;
  std::vector<Time> stamps_;
  std::size_t new_loops_ = 0;
};

}  // namespace ribbon_mapper::slam
