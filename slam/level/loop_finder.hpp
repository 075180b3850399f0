// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "slam/level/level_tracker.hpp"
#include "slam/level/pose_graph.hpp"
#include "slam/matching/correlative_search.hpp"
#include "slam/matching/scan_matcher.hpp"

namespace ribbon_mapper::slam {

/// Settings for closing loops.
struct LoopConfig {
  double every_m = 0.8;              ///< way between two attempts
  double query_m = 6.0;              ///< way of the keyframes that are looked for: short
  double reference_m = 8.0;          ///< way to both sides of a place that they are looked for in
  double least_way_m = 2.0;          ///< shortest way over the graph that is worth a loop
  double radius_m = 1.0;             ///< uncertainty of a short way: wheels slip
  double radius_per_metre = 0.05;    ///< and by way
  double most_radius_m = 20.0;       ///< at most: a search takes time
  double angle_rad = 0.1;            ///< uncertainty of a heading after a short way
  double angle_per_metre = 0.008;    ///< and by way
  double view_m = 3.0;               ///< places so far beyond the uncertainty are worth an attempt
  double least_score = 0.5;          ///< of a search: share of the points on the map
  double least_agreeing = 0.65;      ///< of the match after it
  double second_share = 0.9;         ///< a place is not clear if another one scores so much of it
  double lone_radius_m = 2.5;        ///< beyond, a second loop must agree
  double support_way_m = 12.0;       ///< way between two loops that support each other
  double support_m = 0.4;            ///< and their disagreement
  double support_rad = 0.06;         ///< and their disagreement
  double kernel = 9.0;               ///< see GraphEdge
  double contradicted_chi2 = 200.0;  ///< a loop that is so far off in the end is taken out
  double place_m = 0.01;             ///< deviation that is added: maps bend
  double place_rad = 0.002;          ///< deviation that is added
};

/// What became of a possible loop.
enum class LoopVerdict {
  accepted,     ///< it is in the graph
  ambiguous,    ///< another place fits as well
  disagreeing,  ///< too few points agree after matching
  unsupported,  ///< no second loop agrees
  contradicted  ///< it is far off in the final graph
};

/// Returns the verdict in words.
const char* text_of(LoopVerdict verdict);

/// A possible loop.
struct Loop {
  std::size_t from = 0, to = 0;                           ///< keyframes; `to` is the later one
  PlanarPose T_from_to;                                   ///< as measured
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of it, in `from`
  double score = 0.0;                                     ///< of the search
  double second_score = 0.0;                              ///< of another place; 0 if clear
  double agreeing = 0.0;                                  ///< share of points that agree
  double way_m = 0.0;                                     ///< over the graph when it was found
  LoopVerdict verdict = LoopVerdict::unsupported;         ///< what became of it
};

/// Finds places that the robot has seen before.
class LoopFinder {
 public:
  /// Creates a finder.
  LoopFinder(const LoopConfig& config, const MatchConfig& match) : config_(config), match_(match) {}

  /// Looks for the newest keyframe's surroundings in those of earlier ones, whose poses are those
  /// of the graph. Returns the loops that are to be added to it.
  std::vector<Loop> find(const std::vector<Keyframe>& keyframes, const PoseGraph& graph);

  /// Forgets maps of places: to be called when the graph has changed by much.
  void forget_maps() { maps_.clear(); }

  /// Returns all loops that were judged, accepted or not.
  const std::vector<Loop>& judged() const { return judged_; }
  /// Returns the number of searches.
  std::size_t searches() const { return searches_; }

 private:
  struct Place {
    std::size_t keyframe = 0;
    double way_m = 0.0;
  };
  std::vector<Place> places(const std::vector<Keyframe>& keyframes, const PoseGraph& graph) const;
  LevelPoints surroundings(const std::vector<Keyframe>& keyframes, const PoseGraph& graph,
                           std::size_t centre, double before_m, double after_m,
                           std::size_t end) const;
  const CorrelativeSearch& map_of(const std::vector<Keyframe>& keyframes, const PoseGraph& graph,
                                  const Place& place, std::size_t end);
  bool judge(const std::vector<Keyframe>& keyframes, const PoseGraph& graph, const Place& place,
             const LevelPoints& query, Loop& loop);
  void add(const Loop& loop, const PoseGraph& graph, std::vector<Loop>& accepted);
  double radius_m(double way_m) const;

  LoopConfig config_;
  MatchConfig match_;
  std::map<std::size_t, std::unique_ptr<CorrelativeSearch>> maps_;  ///< by keyframe
  std::vector<Loop> judged_;
  std::vector<std::size_t> pending_;  ///< judged ones that wait for support
  double last_attempt_m_ = 0.0;
  std::size_t searches_ = 0;
};

}  // namespace ribbon_mapper::slam
