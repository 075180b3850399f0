// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "slam/level/level_tracker.hpp"
#include "slam/matching/scan_matcher.hpp"

namespace ribbon_mapper::slam {

/// Settings for matching every scan in the end.
struct FinalMatchConfig {
  std::size_t before = 5, after = 5;  ///< keyframes in time that a scan is matched against
  double prior_m = 0.1;     ///< deviation of the guess: keeps to the tracker where little is seen
  double prior_rad = 0.05;  ///< deviation of the guess
};

/// A scan with where the tracker saw it.
struct ScanToPlace {
  LevelPoints points;   ///< in base
  TrackedScan tracked;  ///< by the tracker
};

/// Returns the pose of each scan in map, matched against the nearest keyframes in time, which lie
/// at `T_map_keyframes`, from three guesses.
std::vector<PlanarPose> final_poses(const std::vector<ScanToPlace>& scans,
                                    const std::vector<Keyframe>& keyframes,
                                    const std::vector<PlanarPose>& T_map_keyframes,
                                    const FinalMatchConfig& config, const MatchConfig& match);

}  // namespace ribbon_mapper::slam
