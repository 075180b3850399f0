// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/recording/recording.hpp"
#include "eval/metrics/map_metrics.hpp"
#include "modeler/modeler.hpp"

namespace ribbon_mapper::bench {

/// A large world made of copies of one tour, each at a different place of a square lattice and
/// later in time.
class Tiles {
 public:
  /// Creates a lattice of `side` columns, `spacing_m` apart. The recording must outlive it.
  Tiles(const Recording& piece, double spacing_m, std::size_t side);

  /// Feeds tile `k` with noisy poses to the modeler. Returns the mean CPU time of its lines [s].
  double feed(std::size_t k, Modeler& modeler) const;

  /// Returns the true poses of the lines of the first `count` tiles.
  std::vector<StampedPose> truth(std::size_t count) const;

  /// Compares the planes in each of the first `count` tiles with the truth of the recording. Planes
  /// outside these tiles are ignored. Returns one result per tile.
  std::vector<eval::MapMetrics> judged(const std::vector<Plane>& planes, std::size_t count) const;

 private:
  Pose T_map_tile(std::size_t k) const;
  /// Returns the tile whose mean of the trajectory is nearest.
  std::size_t tile_at(const Eigen::Vector3d& place) const;
  Time start_of(std::size_t k) const;

  const Recording& piece_;
  double spacing_m_;
  std::size_t side_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();  ///< mean of the first tile's trajectory
};

/// Displaces the last `share` of a trajectory by up to a few centimetres and half a degree, each
/// pose by a different amount.
std::vector<StampedPose> bent(std::vector<StampedPose> trajectory, double share);

/// Returns the slope of log(y) over log(x), fitted by least squares.
double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace ribbon_mapper::bench
