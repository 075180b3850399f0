// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "slam/places/decision.hpp"
#include "slam/places/move_finder.hpp"
#include "slam/places/slip_evidence.hpp"

namespace ribbon_mapper::slam {

/// A history in which lines are moved.
struct CandidateHistory {
  Pose T_start_start;          ///< of the lines behind the seam
  Seam seam;                   ///< before it, lines stay; in it, they are moved in part
  bool is_slip;                ///< the odometry has failed within the seam
  Decision::Kind kind;         ///< if it is chosen
  double lead = 0.0;           ///< the cost that later candidates must save beyond it
  double saved = 0.0;          ///< the cost that it saves where the wheels have slipped
  SlipEvidence evidence = {};  ///< what the lines around the seam say of a slip there

  /// Returns the history without this one, once it was chosen. What had shown a slip counts against
  /// it.
  CandidateHistory taken_back() const;
};

/// Returns the largest scale of the odometry's noise that is still drift, see
/// OdometryNoise::planar_scale.
double max_drift_scale(const OdometryNoise& noise, const RelocaliserConfig& config);

/// Returns true if a move goes farther than a slip, and nothing contradicts that the robot is where
/// it seems to be.
bool is_far(const FoundMove& move, const PosedLines& lines, const RelocaliserConfig& config);

/// Returns the histories in which a move may have been made: by a slip at one moment, or by drift
/// since the place was seen for the last time.
///
/// Where the slip explains most of what the lines around it see, it was made there, and there is no
/// other history. One that they contradict is left out if there are others.
std::vector<CandidateHistory> candidate_histories(const FoundMove& move, const PosedLines& lines,
                                                  const OdometryNoise& noise,
                                                  const EstimateSettings& settings);

}  // namespace ribbon_mapper::slam
