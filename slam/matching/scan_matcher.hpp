// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "slam/matching/surface_map.hpp"

namespace ribbon_mapper::slam {

/// Settings for matching points against a surface.
struct MatchConfig {
  int max_steps = 15;              ///< Gauss-Newton; five are usual
  double first_gate_m = 0.3;       ///< surfaces farther off do not count at the start
  double last_gate_m = 0.15;       ///< and at the end
  double first_width_m = 0.15;     ///< the surface is averaged over so much at the start
  double last_width_m = 0.08;      ///< and at the end: two points apart, so that noise is averaged
  double least_scatter_m = 0.015;  ///< residuals within it count fully; the noise of a good laser
  double first_prior = 0.1;        ///< share of the prior at the start; all of it at the end
  double most_scatter_m = 0.10;    ///< larger ones hardly count, however many there are
  double agreeing_m = 0.10;        ///< a point agrees if its residual is smaller
  /// Points of a scan err together (range offset, angle, clutter): the sum of their information is
  /// divided by this. With it, steps between keyframes differ from the final result by as much as
  /// their information says: the median of the squared normalised error is 1.2 to 3, expected 2.4.
  double correlated = 5.0;
  /// Normals of a straight wall err by this [rad], see information_beyond_normals(). It was
  /// measured with 1 cm of noise and points 4 cm apart.
  double normal_sigma_rad = 0.04;
};

/// How surfaces are looked at in one step: coarsely at first, then finely.
struct MatchStage {
  double width_m = 0.08;           ///< surfaces are averaged over
  double gate_m = 0.15;            ///< surfaces farther off do not count
  double least_scatter_m = 0.015;  ///< residuals within it count fully
  double prior_share = 1.0;        ///< of the prior's information
};

/// What is known about a pose before matching.
struct PosePrior {
  PlanarPose T_map_base;                                  ///< expected
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of x, y [1/m^2], yaw [1/rad^2]
};

/// A pose that was found by matching.
struct Match {
  PlanarPose T_map_base;                                  ///< found
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of the points alone: x, y, yaw in map
  /// What the prior added to it: less than its own where the points contradict it.
  Eigen::Matrix3d prior_information = Eigen::Matrix3d::Zero();
  double agreeing = 0.0;  ///< share of points that agree, 0..1
  double cost = 0.0;      ///< mean robust residual, 0..1; 1: no point fits
  int points = 0;         ///< that were compared
  /// What `information` would be if each surface were turned by a right angle. Normals that err by
  /// an angle feign its square times this, for instance along a bare corridor.
  Eigen::Matrix3d information_across = Eigen::Matrix3d::Zero();
};

/// The linearised misfit of points at a pose.
struct Misfit {
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();   ///< of half the weighted squares [1/m^2]
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< of the same, by x, y, yaw
  Eigen::Matrix3d across = Eigen::Matrix3d::Zero();    ///< hessian of surfaces at a right angle
  double scatter_m = 0.0;                              ///< robust deviation of the residuals
  double agreeing = 0.0;                               ///< share of points that agree
  double cost = 0.0;                                   ///< see Match
  int points = 0;                                      ///< that were compared
};

/// Returns the stage of a Gauss-Newton step. At first the few points that are far off, such as the
/// end of a corridor, must not be outvoted by the many that fit anyway, nor by the prior.
MatchStage stage_of(int step, const MatchConfig& config);

/// Returns the misfit of points at a pose. Residuals count by 1 / (1 + (r / scatter)^2)^2 (Geman
/// and McClure 1987). Points without a normal are left out.
Misfit misfit_at(const LevelPoints& points, const SurfaceMap& map, const PlanarPose& T_map_base,
                 const MatchStage& stage, const MatchConfig& config);

/// Returns the pose at which the points fit the map best, found by Gauss-Newton steps from a guess.
/// The prior is robust: it yields where many points contradict it.
Match match(const LevelPoints& points, const SurfaceMap& map, const PlanarPose& guess,
            const std::optional<PosePrior>& prior, const MatchConfig& config);

/// Returns the information of the points in a match, less twice what errors of normals feign. It is
/// zero along a bare corridor. Normals that err make a direction look observed that is not
/// (Hatleskog and Alexis, 'Probabilistic degeneracy detection for point-to-plane error
/// minimization', 2024).
Eigen::Matrix3d information_beyond_normals(const Match& match, const MatchConfig& config);

}  // namespace ribbon_mapper::slam
