// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "slam/tilting/decision.hpp"
#include "slam/tilting/history_cost.hpp"
#include "slam/tilting/place_search.hpp"
#include "slam/tilting/seam.hpp"

namespace ribbon_mapper::slam {

/// Notices that the robot may be on known ground at a wrong pose, and moves the newest poses onto
/// what older lines have seen.
///
/// The walls that the last seconds show are compared with those that older lines know. Where the
/// known ones end, a *break* begins: the robot is on new ground, or its odometry has failed. As
/// long as a break is open, each call searches for a move of the newest lines onto what was known
/// before the break. A move is made if it explains clearly more, and if the history with it costs
/// less, see HistoryCost. It is taken back if the history without it costs less later. A break is
/// closed when what was known before it is seen again where it is expected.
class Relocaliser {
 public:
  /// Starts on known ground.
  explicit Relocaliser(const EstimateSettings& settings) : settings_(settings) {}

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
  /// Where known ground ended.
  struct Break {
    std::uint32_t line = 0;           // the first one that may be beyond
    bool is_settled = false;          // what lies beyond is known by itself
    bool is_left = false;             // nothing of what was known before is in view
    std::optional<KnownScene> scene;  // what was known before, near `centre`
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  };
  /// A move that explains clearly more.
  struct Find {
    Pose T_start_start;       // of the lines behind the seam
    Seam seam;                // where lines cease to fit unmoved
    std::uint32_t torn_from;  // only older lines were looked at
    std::uint32_t last_seen;  // line at which the known walls had been seen for the last time
    double gain_m;            // length that it makes known
    std::string evidence;     // why
  };
  /// A history in which lines are moved.
  struct Candidate {
    Pose T_start_start;   // of the lines behind the seam
    Seam seam;            // before it, lines stay; in it, they are moved in part
    bool is_slip;         // the odometry has failed within the seam
    Decision::Kind kind;  // if it is chosen
  };
  void look_at_recent(const PosedLines& lines, const LineRange& query, double tracked_share);
  void open_break(const LineRange& query, const Agreement& now);
  const KnownScene& scene_before(Break& torn, const PosedLines& lines) const;
  bool search_before(Break& torn, const PosedLines& lines, const LineRange& query);
  void consider(const PosedLines& lines, const LineRange& range, std::uint32_t torn_from,
                const KnownScene& scene);
  std::vector<Candidate> candidates(const PosedLines& lines, const OdometryNoise& noise) const;
  bool choose(PosedLines& lines, const LineRange& range, const OdometryNoise& noise);
  void decide(Decision::Kind kind, const PosedLines& lines, const std::string& reason);

  EstimateSettings settings_;
  std::vector<Break> breaks_;              // open ones, in their order
  std::optional<Candidate> on_probation_;  // what takes the last move back
  Time probation_end_{0}, doubted_until_{0};
  bool is_lost_ = false;
  std::vector<Decision> decisions_;
  // Of a call.
  std::optional<Find> find_;  // the best one
  std::string doubt_;         // why the robot may be lost; empty if it is not
};

}  // namespace ribbon_mapper::slam
