// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "bench/recording/recording.hpp"
#include "modeler/modeler_config.hpp"

namespace ribbon_mapper::bench {

/// What no correction can do without: moving the statistics and the samples of every ribbon once to
/// where its acquisition pose is now. Packed as tightly as can be.
class RibbonFloor {
 public:
  /// Extracts the ribbons of a tour as the modeler does.
  RibbonFloor(const Recording& tour, const ModelerConfig& config);

  std::size_t ribbons() const { return sources_.size(); }
  std::size_t samples() const { return sample_points_.size(); }

  /// The work itself; `T_map_base` by line of the tour.
  void move(const std::vector<Pose>& T_map_base);

 private:
  struct Sums {
    double weight, x, y, z, xx, xy, xz, yy, yz, zz;
  };
  struct Source {
    Sums sums;
    std::uint32_t line, first_sample, end_sample;
  };
  std::vector<Source> sources_;
  std::vector<Eigen::Vector3f> sample_points_;
  std::vector<Sums> moved_sums_;
  std::vector<Eigen::Vector3f> moved_points_;
};

}  // namespace ribbon_mapper::bench
