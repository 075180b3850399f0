// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "slam/lines/known_planes.hpp"

namespace ribbon_mapper::slam {

/// Follows the robot line by line: odometry predicts each pose, and the line's ribbons on planes
/// that are known correct it.
///
/// Ribbons on no known plane are gathered to new planes, which correct later lines.
class LineTracker {
 public:
  /// Starts at a pose without error and without known planes.
  explicit LineTracker(const EstimateSettings& settings);

  /// Estimates and sets the pose of a line, which follows the one before.
  void track(PosedLines& lines, std::uint32_t line, const OdometryNoise& noise);

  /// Replaces the known planes, and the belief of the last line's pose.
  void restart(KnownPlanes planes, const PoseBelief& belief);

  /// Returns the share of the walls seen since the last restart that were known then, by the length
  /// of their ribbons; 1 if no wall was seen.
  double known_share() const { return seen_m_ > 0.0 ? known_m_ / seen_m_ : 1.0; }

  /// Returns the belief of the last line's pose.
  const PoseBelief& belief() const { return belief_; }

 private:
  void list_candidates(const PosedLines& lines, std::uint32_t line);
  void add_ribbons(const PosedLines& lines, std::uint32_t line);

  EstimateSettings settings_;
  PoseBelief belief_;
  std::optional<KnownPlanes> known_;
  PlaneMap new_planes_;
  double seen_m_ = 0.0, known_m_ = 0.0;  // length of ribbons on walls since the last restart
  // Of the line.
  std::vector<PlaneObservation> observations_;
  std::vector<PlaneLandmark> landmarks_;
  std::vector<std::uint32_t> known_numbers_;  // by landmark; kNew for a new plane
};

}  // namespace ribbon_mapper::slam
