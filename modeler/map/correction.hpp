// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// Change of a trajectory: what takes a pose as it was recorded to where a corrected trajectory
/// says it was. At a corrected pose's time it is exactly that pose; between two of them the change,
/// not the pose, is interpolated, so the odometry in between survives; before the first and after
/// the last, the nearest change holds.
class Correction {
 public:
  /// Poses of `corrected` that lie outside of the time of `recorded` (in order, not empty) are left
  /// out. Throws std::invalid_argument saying what is wrong if `corrected` is empty, not strictly
  /// in order, not finite, or if none of its poses lies within the time of `recorded`.
  Correction(const std::vector<StampedPose>& recorded, const std::vector<StampedPose>& corrected);

  Pose corrected(const StampedPose& recorded) const;

 private:
  std::vector<StampedPose> changes_;  // T_map_base holds T_corrected_recorded
};

}  // namespace ribbon_mapper
