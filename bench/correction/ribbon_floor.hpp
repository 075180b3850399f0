// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "modeler/modeler.hpp"

namespace ribbon_mapper::bench {

/// Lower bound of the work of any correction: transforms moments and samples of every ribbon once
/// by its acquisition pose. All data are packed tightly.
class RibbonFloor {
 public:
  /// Copies the ribbons of a model.
  explicit RibbonFloor(const Modeler& modeler);

  /// Returns the number of ribbons.
  std::size_t ribbons() const { return sources_.size(); }

  /// Returns the number of samples.
  std::size_t samples() const { return sample_points_.size(); }

  /// Transforms all ribbons by the model's trajectory.
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
