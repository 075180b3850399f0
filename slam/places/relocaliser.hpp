// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "slam/places/candidate_history.hpp"
#include "slam/places/decision.hpp"
#include "slam/places/history_cost.hpp"
#include "slam/places/move_finder.hpp"

namespace ribbon_mapper::slam {

/// Moves the newest poses onto what older lines have seen, if the robot is on known ground at a
/// wrong pose.
///
/// Of the histories in which a move may have been made, see candidate_histories(), the one of least
/// cost is kept, see HistoryCost: none of them if they save less than the cost of a plane. What the
/// lines around a slip say of it counts among those that save enough, see SlipEvidence. A move
/// that saves ribbons alone, or goes farther than a slip, is made when two looks find it. One that
/// leaves most of what is in view unknown has to explain more ribbons by fewer planes. A move is
/// taken back if the history without it costs less later.
class Relocaliser {
 public:
  /// Starts on known ground.
  explicit Relocaliser(const EstimateSettings& settings) : settings_(settings), finder_(settings) {}

  /// Looks at the newest lines, whose poses are adjusted. `tracked_share` of the walls in view was
  /// known since the last call, see LineTracker::known_share(). Returns true if poses were moved.
  bool look(PosedLines& lines, double tracked_share, const OdometryNoise& noise);

  /// Follows lines that were thinned since: forgets what it knew of them.
  void forget_lines();

  /// Returns true while the robot may be on known ground at a wrong pose.
  bool is_lost() const { return is_lost_; }
  /// Returns all decisions, in their order.
  const std::vector<Decision>& decisions() const { return decisions_; }

 private:
  /// A candidate that costs less than no move.
  struct Choice {
    CandidateHistory candidate;
    PosedLines lines;           // moved and adjusted
    HistoryCost before, after;  // without it and with it
  };
  /// A move that was not made yet.
  struct Proposal {
    Pose T_start_start;
    Time stamp;  // of the newest line
  };
  std::vector<CandidateHistory> candidates(const Finding& finding, const PosedLines& lines,
                                           const OdometryNoise& noise) const;
  PosedLines history_with(const CandidateHistory& candidate, std::uint32_t first,
                          const PosedLines& lines, const OdometryNoise& noise) const;
  std::optional<Choice> best_of(const std::vector<CandidateHistory>& histories,
                                const Finding& finding, const PosedLines& lines,
                                const OdometryNoise& noise) const;
  bool is_clear(const Choice& choice, const FoundMove& move, const PosedLines& lines) const;
  bool propose(const CandidateHistory& candidate, const PosedLines& lines);
  bool choose(const Finding& finding, PosedLines& lines, const OdometryNoise& noise);
  void decide(Decision::Kind kind, const PosedLines& lines, const std::string& reason);

  EstimateSettings settings_;
  MoveFinder finder_;
  std::optional<CandidateHistory> way_back_;  // what takes the last move back
  Time way_back_until_{0};
  std::optional<Proposal> proposal_;
  bool is_lost_ = false;
  std::vector<Decision> decisions_;
};

}  // namespace ribbon_mapper::slam
