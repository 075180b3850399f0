// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "slam/matching/level_scan.hpp"

namespace ribbon_mapper::slam {

/// How far a search goes about its guess.
struct SearchWindow {
  double radius_m = 1.0;     ///< half the side of the square of positions
  double angle_rad = 0.1;    ///< to both sides
  double least_score = 0.5;  ///< worse poses are not found
};

/// A pose that was found by a search.
struct SearchResult {
  PlanarPose T_map_base;         ///< the best one
  double score = 0.0;            ///< share of the points that lie on the map, 0..1
  double second_score = 0.0;     ///< of the best pose elsewhere, if it is near the best; else 0
  PlanarPose T_map_base_second;  ///< that pose
};

/// Finds the pose at which points lie on a map, by branch and bound over all poses of a window: the
/// best one is found for certain (Hess, Kohler, Rapp and Andor, ICRA 2016).
class CorrelativeSearch {
 public:
  /// Makes the map of points. Farther ones than `kMaxExtent_m` from its origin are left out.
  explicit CorrelativeSearch(const LevelPoints& points);

  /// Returns the best pose in a window about a guess; nothing if all score less than its least
  /// score. `second_share`: poses elsewhere that score so much of the best are looked for; 0: not.
  std::optional<SearchResult> find(const LevelPoints& points, const PlanarPose& guess,
                                   const SearchWindow& window, double second_share) const;

  static constexpr double kCell_m = 0.1;        ///< accuracy of a position
  static constexpr double kMaxExtent_m = 60.0;  ///< of the map, from its origin

 private:
  static constexpr int kLevels = 6;
  using Offsets = std::vector<std::pair<int, int>>;
  struct Candidate;
  struct Task;
  void pool();
  int value(int level, int x, int y) const;
  int sum(const Offsets& points, int level, int x, int y) const;
  std::vector<Candidate> coarsest(const Task& task) const;
  void descend(const Candidate& candidate, Task& task) const;
  std::optional<Candidate> best(Task& task) const;

  int left_ = 0, bottom_ = 0, columns_ = 0, rows_ = 0;
  std::vector<std::vector<std::uint8_t>> grids_;  ///< by level; each the largest of 2^level squared
};

/// Returns points that lie at least `spacing_m` apart, for a search.
LevelPoints thinned(const LevelPoints& points, double spacing_m);

}  // namespace ribbon_mapper::slam
