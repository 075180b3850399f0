// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "modeler/modeler.hpp"

namespace ribbon_mapper::bench {

/// What no correction can do without: moving the statistics and the samples of every ribbon once to
/// where its acquisition pose is now. Packed as tightly as can be.
class RibbonFloor {
 public:
  /// The ribbons of a model.
  explicit RibbonFloor(const Modeler& modeler);

  std::size_t ribbons() const { return sources_.size(); }
  std::size_t samples() const { return sample_points_.size(); }

  /// The work itself; the trajectory is that of the model.
  void move(const std::vector<StampedPose>& trajectory);

 private:
  struct Sums {
    double weight, x, y, z, xx, xy, xz, yy, yz, zz;
  };
  struct Source {
    Sums sums;
    std::uint32_t pose, first_sample, end_sample;
  };
  std::vector<Source> sources_;
  std::vector<Eigen::Vector3f> sample_points_;
  std::vector<Sums> moved_sums_;
  std::vector<Eigen::Vector3f> moved_points_;
};

}  // namespace ribbon_mapper::bench
