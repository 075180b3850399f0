// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper::eval {

/// The absolute trajectory error (ATE) of Sturm et al., 'A Benchmark for the Evaluation of RGB-D
/// SLAM Systems', IROS 2012.
struct TrajectoryError {
  double rmse_m = 0.0;          ///< root mean square of the position error
  double largest_m = 0.0;       ///< largest position error
  double rmse_deg = 0.0;        ///< root mean square of the angle of the orientation error
  double aligned_rmse_m = 0.0;  ///< as rmse_m, after the rigid motion that makes it least
};

/// Returns the error of a trajectory. Both have the same stamps. Without alignment, the error of
/// the first poses counts for the whole map; with it, only the shape of the trajectory does.
/// Throws std::invalid_argument if they are empty or of different lengths.
TrajectoryError trajectory_error(const std::vector<StampedPose>& estimate,
                                 const std::vector<StampedPose>& truth);

}  // namespace ribbon_mapper::eval
