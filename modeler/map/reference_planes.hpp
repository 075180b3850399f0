// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/map/evidence.hpp"
#include "modeler/map/plane_map.hpp"
#include "modeler/map/pose_belief.hpp"

namespace ribbon_mapper {

/// What a ribbon measures of a plane's place: the distance of its centroid from it, and the tilt of
/// its direction against it. (How it lies across its direction depends on the odometry from line to
/// line and is only used to tell planes apart.) In the frame of its acquisition pose.
struct Sight {
  Sight(const Ribbon& ribbon, double range_sigma_m, const Vector6& motion_variances);

  Eigen::Vector3d centroid, normal, along, across;
  double sigma_across_rad;
  /// Of distance [m2] and tilt [rad2] from the noise of ranges and of the motion within a line.
  double distance_variance, tilt_variance;
  std::vector<std::uint32_t> planes;  ///< that it may lie on
};

/// d(distance) and d(tilt) by an error of the pose, see PoseBelief.
using Jacobian = Eigen::Matrix<double, 2, 6>;
Jacobian jacobian_of(const Sight& sight, const Eigen::Vector3d& normal, const Pose& T_world_base);

/// Planes that ribbons are registered against.
class ReferencePlanes {
 public:
  /// Of the ribbons whose line is `is_placed` (by acquisition pose), those confirmed.
  ReferencePlanes(const Evidence& evidence, const std::vector<char>& is_placed,
                  const PlaneMapConfig& config);

  /// Sets the planes that are near a ribbon.
  void find_near(const PosedRibbon& ribbon, Sight& sight);

  /// What a line's ribbons say about its pose, given where it is believed to be without them.
  Observation observe(const std::vector<Sight>& sights, const PoseBelief& without_them) const;

 private:
  struct Match {
    std::uint32_t plane;
    double square_sigmas;  ///< of the innovation
    Eigen::Vector2d residual;
  };
  void enter(std::uint32_t slot, const Hypothesis& hypothesis, const Evidence& evidence);
  bool fits_across(const Sight& sight, const Eigen::Vector3d& normal,
                   const PoseBelief& belief) const;
  std::vector<Match> matches_of(const Sight& sight, const PoseBelief& belief) const;
  Observation linearised(const std::vector<Sight>& sights, const PoseBelief& belief) const;

  struct OrientedPlane {
    Eigen::Vector3d normal;
    double d_m;
  };
  double angle_gate_rad_;
  std::vector<OrientedPlane> planes_;
  VoxelIndex index_;
  std::vector<VoxelKey> voxels_;  // scratch
};

}  // namespace ribbon_mapper
