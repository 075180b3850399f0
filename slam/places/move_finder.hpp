// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "slam/places/seam.hpp"

namespace ribbon_mapper::slam {

/// A move of the newest lines that explains clearly more of what they see.
struct FoundMove {
  Pose T_start_start;       ///< of the lines behind the seam
  Seam seam;                ///< where lines cease to fit unmoved
  std::uint32_t last_seen;  ///< line that saw the known walls for the last time
  double gain_m;            ///< length of ribbons that it makes known
  bool is_partial;          ///< most of what is in view stays unknown
  bool is_contradicted;     ///< known walls stand before what is in view, or did
  double freed_m;           ///< length of ribbons that are no longer seen through known walls
  /// The line before the seam where known walls began to contradict what was in view, and no move
  /// was found, if there is one.
  std::optional<std::uint32_t> tear;
  std::string evidence;  ///< the figures
};

/// What a look at the newest lines has shown.
struct Finding {
  std::optional<FoundMove> move;  ///< the best one, if it is clear
  std::string doubt;              ///< why the robot may be lost; empty if nothing says so
};

/// Finds out whether the newest lines see known ground at a wrong pose.
///
/// Their walls are compared with those that older lines know. Where the known ones end, a *break*
/// begins: the robot is on new ground, or its odometry has failed. As long as a break is open, each
/// call searches for a move of the newest lines onto what was known before the break. A break is
/// closed when what was known before it is seen again where it is expected. What the call before
/// has found tells two moves apart, and makes up for walls that are new.
class MoveFinder {
 public:
  /// Starts on known ground.
  explicit MoveFinder(const EstimateSettings& settings) : settings_(settings) {}

  /// Looks at the newest lines. `tracked_share` of the walls in view was known since the last call,
  /// see LineTracker::known_share(). Lines that need more than `max_scale` of the odometry's noise
  /// contradict it, see most_strained().
  Finding find(const PosedLines& lines, double tracked_share, double max_scale);

  /// Closes all breaks: after a move, or when lines are gone.
  void forget_breaks() { breaks_.clear(), found_.clear(); }

 private:
  /// Where known ground ended.
  struct Break {
    std::uint32_t line = 0;             // the first one that may be beyond
    bool is_settled = false;            // what lies beyond is known by itself
    std::optional<std::uint32_t> tear;  // where known walls begin to stand before what is in view
    bool is_left = false;               // nothing of what was known before is in view
    std::optional<KnownScene> scene;    // what was known before, near `centre`
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  };
  /// Some lines, and what they are compared with: older lines than `torn_from`.
  struct Question {
    LineRange range;
    std::uint32_t torn_from;
    Agreement unmoved;                  // where the lines are
    std::optional<std::uint32_t> tear;  // where known walls began to stand before what was in view
  };

  void look_at_recent(const PosedLines& lines, const LineRange& newest, double tracked_share);
  void open_break(const PosedLines& lines, const LineRange& newest, const Agreement& now,
                  const KnownScene& scene);
  std::optional<std::uint32_t> newly_strained(const PosedLines& lines) const;
  std::optional<std::uint32_t> last_tear_before(std::uint32_t line) const;
  double radius_m(std::uint32_t line, const PosedLines& lines) const;
  double reach_m(const Break& torn, const PosedLines& lines) const;
  const KnownScene& scene_before(Break& torn, const PosedLines& lines) const;
  bool search_before(Break& torn, const PosedLines& lines, const LineRange& newest);
  std::optional<LineRange> range_behind(const Break& torn, const PosedLines& lines,
                                        const KnownScene& scene) const;
  Agreement agreement(const PosedLines& lines, const LineRange& range, const Pose& T_start_start,
                      const KnownScene& scene) const;
  void ask(const Question& question, const PosedLines& lines, const KnownScene& scene);
  bool was_found_before(const PlaceMove& move, const PosedLines& lines) const;
  void tell_apart(std::vector<PlaceMove>& moves, const PosedLines& lines) const;
  bool contradicts_newest(const Pose& T_start_start, const PosedLines& lines,
                          const KnownScene& scene) const;
  void judge(const Question& question, const std::vector<PlaceMove>& moves, const PosedLines& lines,
             const KnownScene& scene);

  EstimateSettings settings_;
  std::vector<Break> breaks_;  // open ones, in their order
  Time doubted_until_{0};
  double max_scale_ = 0.0;
  Finding finding_;                         // of a call
  std::vector<Pose> found_, found_before_;  // moves of this call and of the one before
};

}  // namespace ribbon_mapper::slam
