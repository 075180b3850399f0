// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper::sim {

/// Height of the ground along a way, linear from waypoint to waypoint. A PR2 on it stands on its
/// front and its rear casters.
class GroundProfile {
 public:
  /// Creates level ground at height 0.
  GroundProfile() = default;
  /// Creates a profile from heights [m] at ways [m, measured in the plane], which increase.
  GroundProfile(std::vector<double> ways_m, std::vector<double> heights_m);

  /// Returns true if all of the ground is at height 0.
  bool is_level() const;
  /// Returns the height of the ground; before the first and beyond the last way it goes on level.
  double height_m(double way_m) const;
  /// Returns the pose of a base that stands at `way_m` and looks along the way, in the frame of the
  /// same base on level ground at height 0: its height and its pitch.
  Pose T_level_base(double way_m) const;
  /// Returns true if both casters stand at the height of `way_m`, so that the base can turn.
  bool is_level_at(double way_m) const;

 private:
  std::vector<double> ways_m_, heights_m_;
};

}  // namespace ribbon_mapper::sim
