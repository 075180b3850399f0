// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/ribbon/distance_intervals.hpp"
#include "modeler/ribbon/orientation_grid.hpp"
#include "modeler/ribbon/surfel.hpp"

namespace ribbon_mapper {

/// Clusters surfels by orientation, then by distance (section 4.2 of the paper). Keeps its working
/// memory from line to line, and no other state.
class SurfelClusters {
 public:
  static constexpr int kNone = -1;  ///< the cluster of a surfel that is in none

  /// Creates clusters without surfels. `config` must be valid.
  explicit SurfelClusters(const RibbonConfig& config);

  /// Finds the clusters of all surfels of a line, whose sensor is at `sensor_origin` in odom [m].
  void classify(const std::vector<Surfel>& surfels, const Eigen::Vector3d& sensor_origin);

  /// Returns the cluster of each surfel, or kNone.
  const std::vector<int>& of_surfels() const { return cluster_; }

 private:
  /// A surfel's vote.
  struct Vote {
    Eigen::Vector3d normal;
    double area_m2;
    std::uint32_t surfel, cell;
  };
  struct Orientation {
    Eigen::Vector3d normal;
    double area_m2;
  };

  void vote(const std::vector<Surfel>& surfels);
  Eigen::Vector3d sum_around(const Eigen::Vector3d& normal) const;
  Orientation take_around(const Eigen::Vector3d& normal);
  void split_by_distance(const std::vector<Surfel>& surfels, const Eigen::Vector3d& normal,
                         const Eigen::Vector3d& sensor_origin);

  double min_cosine_, min_area_m2_;
  OrientationGrid grid_;
  std::vector<Vote> votes_;          // not yet in a cluster of one orientation
  std::vector<Vote> members_;        // of the present one
  std::vector<double> distances_m_;  // of the members
  DistanceIntervals intervals_;
  std::vector<int> cluster_;
  int clusters_ = 0;
};

}  // namespace ribbon_mapper
