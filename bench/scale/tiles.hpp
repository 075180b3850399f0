// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bench/recording/recording.hpp"
#include "eval/metrics/map_metrics.hpp"
#include "modeler/modeler.hpp"

namespace ribbon_mapper::bench {

/// A large world made of one tour: it is driven again and again, each time in another place of a
/// square lattice and later in time.
class Tiles {
 public:
  /// The recording must outlive the tiles.
  Tiles(const Recording& piece, double spacing_m, std::size_t side);

  /// Feeds tile `k` with the poses that the robot believed; the mean CPU time of its lines [s].
  double feed(std::size_t k, Modeler& modeler) const;

  /// Where the lines of the first `count` tiles really were.
  std::vector<StampedPose> truth(std::size_t count) const;

  /// Planes in map by the tile that they lie in, held against the truth of the recording: one
  /// result for each of the first `count` tiles. Planes of no tile are left out.
  std::vector<eval::MapMetrics> judged(const std::vector<Plane>& planes, std::size_t count) const;

 private:
  Pose T_map_tile(std::size_t k) const;
  /// The one whose trajectory has the nearest mean.
  std::size_t tile_at(const Eigen::Vector3d& place) const;
  Time start_of(std::size_t k) const;

  const Recording& piece_;
  double spacing_m_;
  std::size_t side_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();  ///< mean of the first tile's trajectory
};

/// The last `share` of a trajectory bent away, up to a few centimetres and half a degree: each of
/// its poses by another amount.
std::vector<StampedPose> bent(std::vector<StampedPose> trajectory, double share);

/// Slope of log(y) over log(x): how y grows with x.
double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace ribbon_mapper::bench
