// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// Notices that the robot is back where it started, after a way that is worth the name of a loop.
class LoopDetector {
 public:
  LoopDetector(double radius_m, double min_travel_m)
      : radius_m_(radius_m), min_travel_m_(min_travel_m) {}

  /// True when the robot enters the radius about its start; the way counts from there again.
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
