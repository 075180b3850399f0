// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/chain/matrix6.hpp"
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

/// Returns the normalised estimation error squared (NEES; Bar-Shalom et al., 'Estimation with
/// Applications to Tracking and Navigation', 2001) of x, y and heading, for each of them: the mean
/// over all poses but the first, which is taken as exact. One is honest: below, covariances are too
/// large, above, too small. Covariances are of errors as those of PoseBelief, along the axes of the
/// trajectories' frame. Throws std::invalid_argument if lengths differ or there is one pose.
double planar_nees(std::vector<StampedPose> estimate, const std::vector<Matrix6>& covariances,
                   const std::vector<StampedPose>& truth);

}  // namespace ribbon_mapper::eval
