// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "slam/lines/context.hpp"
#include "slam/matching/correlative_search.hpp"
#include "slam/matching/planar_pose.hpp"
#include "slam/matching/surface_map.hpp"
#include "slam/places/known_scene.hpp"

namespace ribbon_mapper::slam {

/// How far lines see what is known, by the length of their ribbons on walls.
struct Agreement {
  double seen_m = 0.0;     ///< all ribbons
  double known_m = 0.0;    ///< those on known walls
  double pierced_m = 0.0;  ///< those seen through known walls

  /// Returns the share of the ribbons on known walls; 1 if there are no ribbons.
  double known() const { return seen_m > 0.0 ? known_m / seen_m : 1.0; }
  /// Returns the length that speaks for where the lines are [m].
  double evidence_m() const { return known_m - pierced_m; }
  /// Returns the share of the ribbons seen through known walls.
  double pierced() const { return seen_m > 0.0 ? pierced_m / seen_m : 0.0; }
};

/// Returns true if lines are on known ground at a right pose.
inline bool is_known_ground(const Agreement& agreement, const RelocaliserConfig& config) {
  return agreement.known() >= config.known_share && agreement.pierced() < config.pierced_share;
}

/// Returns true if what lines see cannot be new ground: known walls would stand before it.
inline bool is_contradiction(const Agreement& agreement, const RelocaliserConfig& config) {
  return agreement.pierced() >= config.pierced_share && agreement.known() < config.least_known;
}

/// Returns a transform in the plane of the floor as one in space.
Pose in_space(const PlanarPose& planar);

/// Returns how far lines see what is known if they are moved by `T_start_start`.
Agreement agreement_of(const PosedLines& lines, const LineRange& range, const Pose& T_start_start,
                       const KnownScene& scene, const AssociationGates& gates);

/// A move of lines in the plane that puts them on known walls.
struct PlaceMove {
  Pose T_start_start;   ///< takes the lines from where they are
  PlanarPose at_robot;  ///< the same move as seen from the newest line: how far it goes
  Agreement agreement;  ///< of the moved lines
};

/// Returns true if two moves, as seen from the robot, differ by less than a search can tell.
bool is_same_move(const PlanarPose& a, const PlanarPose& b);

/// Returns the same for moves in start, by what they do to a robot at `T_start_base`.
bool is_same_move(const Pose& a, const Pose& b, const Pose& T_start_base);

/// A ribbon on a known wall.
struct KnownRibbon {
  const KnownScene::Wall* wall;  ///< of the scene, not owned
  double length_m;               ///< of the ribbon
};

/// Returns the ribbons of lines that lie on known walls if they are moved by `T_start_start`.
std::vector<KnownRibbon> known_ribbons(const PosedLines& lines, const LineRange& range,
                                       const Pose& T_start_start, const KnownScene& scene,
                                       const AssociationGates& gates);

/// Returns the direction in the plane in which no known wall holds lines that are moved by
/// `T_start_start`: fewer ribbons than it takes to believe in a plane lie on walls across it.
/// Nothing if they are held in all directions.
std::optional<Eigen::Vector2d> open_direction(const PosedLines& lines, const LineRange& range,
                                              const Pose& T_start_start, const KnownScene& scene,
                                              const EstimateSettings& settings);

/// The search for the place of some lines in a known scene.
class PlaceSearch {
 public:
  /// Prepares it. All that is passed must outlive the search.
  PlaceSearch(const PosedLines& lines, const LineRange& range, const KnownScene& scene,
              const EstimateSettings& settings);

  /// Returns the moves within a window that put most ribbons on known walls, the best first: one,
  /// or two if another one puts nearly as much there, or none. The window reaches `radius_m` from
  /// the pose of `pivot_line`: a slip there turns all later poses about it. In an open direction,
  /// the newest line stays where it is.
  std::vector<PlaceMove> moves_about(std::uint32_t pivot_line, double radius_m) const;

 private:
  std::optional<PlaceMove> move_to(const PlanarPose& guess, const SurfaceMap& surfaces) const;

  const PosedLines& lines_;
  const LineRange range_;
  const KnownScene& scene_;
  const EstimateSettings& settings_;
  const PlanarPose here_;           ///< of the newest line
  const LevelPoints seen_;          ///< by the lines, in start
  const LevelPoints known_;         ///< of the scene
  const CorrelativeSearch search_;  ///< on the scene
};

}  // namespace ribbon_mapper::slam
