// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/registration/plane_landmarks.hpp"
#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {

/// The settings of other stages with which walls become landmarks.
const SharedSettings kShared{0.01, {2.0, 0.03}, 1.0};

/// Walls at given x, each of ribbons that are acquired from lines of their own at the origin.
class Walls {
 public:
  /// Adds a wall of 1 m length and `ribbons` ribbons 4 cm apart, that faces the origin. Its lines
  /// are localised by the segment, if one is given.
  void add(double x_m, int ribbons, std::optional<std::uint32_t> segment = {}) {
    for (int i = 0; i < ribbons; ++i) {
      Ribbon ribbon = ribbon_at(x_m, 0.5 + 0.04 * i);
      ribbon.pose = static_cast<std::uint32_t>(lines.size());
      ribbons_.push_back(ribbon);
      lines.push_back({});
      lines.back().localised_by = segment;
    }
  }

  /// Returns a ribbon of 1 m length that faces the origin.
  static Ribbon ribbon_at(double x_m, double z_m, double y_m = 0.0) {
    return mini_world::ribbon_between({x_m, y_m - 0.5, z_m}, {x_m, y_m + 0.5, z_m},
                                      -Eigen::Vector3d::UnitX());
  }

  /// Returns the walls as landmarks.
  PlaneLandmarks landmarks(const RegistrationConfig& config = {}) const {
    const std::vector<StampedPose> poses(lines.size());
    const PosedObservations observations(ribbons_, no_points_, poses);
    return {supported_planes(observations, lines, config, kShared),
            [&](std::uint32_t ribbon) { return observations.ribbon(ribbon); },
            kShared.bridged_gap_m, config};
  }

  std::vector<LineState> lines;  ///< of each ribbon

 private:
  std::vector<Ribbon> ribbons_;
  std::vector<UnassignedPoints> no_points_;
};

/// Returns a wall at x = 2 m.
inline Walls one_wall(int ribbons = 12) {
  Walls walls;
  walls.add(2.0, ribbons);
  return walls;
}

/// Returns walls at x = 2 m and 2.2 m.
inline Walls two_walls() {
  Walls walls = one_wall();
  walls.add(2.2, 12);
  return walls;
}

}  // namespace ribbon_mapper
