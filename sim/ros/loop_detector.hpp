// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// Detects that the robot has returned to its start after a minimum travel.
class LoopDetector {
 public:
  /// Creates a detector for a circle of `radius_m` about the first pose.
  LoopDetector(double radius_m, double min_travel_m)
      : radius_m_(radius_m), min_travel_m_(min_travel_m) {}

  /// Adds a pose. Returns true when the robot is within the radius after at least the minimum
  /// travel; travel is then counted from zero again.
  bool closes_with(const Pose& T_map_base) {
    const Eigen::Vector3d place = T_map_base.translation();
    if (!start_) start_ = last_ = place;
    travel_m_ += (place - last_).norm();
    last_ = place;
    if (travel_m_ < min_travel_m_ || (place - *start_).norm() > radius_m_) return false;
    travel_m_ = 0.0;
    return true;
  }

 private:
  double radius_m_, min_travel_m_;
  std::optional<Eigen::Vector3d> start_;
  Eigen::Vector3d last_ = Eigen::Vector3d::Zero();
  double travel_m_ = 0.0;
};

}  // namespace ribbon_mapper
