// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "modeler/modeler.hpp"

/// A world of a few faces whose ranges are known in closed form, and a laser that is driven through
/// it: the truth of the modeler's tests. It shares nothing with sim/.
namespace ribbon_mapper::mini_world {

/// The part of the plane normal.p + d = 0 that lies in a box, in map; seen from either side.
struct Face {
  Eigen::Vector3d normal;
  double d_m;
  Eigen::AlignedBox3d bounds;
};
using World = std::vector<Face>;

/// Unbounded.
Face plane(const Eigen::Vector3d& normal, double d_m);
/// Bounded: what of it lies between two corners.
Face plane(const Eigen::Vector3d& normal, double d_m, const Eigen::Vector3d& least,
           const Eigen::Vector3d& most);

/// Six faces around 6 x 5 x 2.5 m, the middle of the floor at the origin; normals point inwards.
World room();

/// Distance to the nearest face [m], infinite if there is none.
double range_m(const World& world, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction);

using PoseByTime = std::function<Pose(double time_s)>;
using AngleByTime = std::function<double(double time_s)>;

/// What moves, by time, and what odometry makes of it.
struct Motion {
  PoseByTime T_map_base;  ///< truth
  AngleByTime tilt_rad;   ///< of the laser, positive looks down
  PoseByTime drift;       ///< the pose that a SLAM reports is drift * truth
};

Pose no_drift(double time_s);
/// Grows to 0.3 m and 4 degrees within 15 s.
Pose wandering_drift(double time_s);
/// To and fro at a constant speed of 0.8 rad/s within +-1.2 rad.
double to_and_fro(double time_s);
/// Turns once and drives 0.6 m around the origin within 15 s.
Pose around_the_middle(double time_s);

/// A robot that stands at the origin and tilts to and fro.
Motion tilting_in_place();

/// A laser of `beams` over 180 degrees, 40 lines a second of which 18.5 ms are beams' time, 1.2 m
/// above the base.
struct Laser {
  std::size_t beams = 361;
  double range_sigma_m = 0.005;
  unsigned seed = 1;
};
Pose T_base_laser(double tilt_rad);

struct Line {
  LaserBeams beams;
  LinePoses poses;       ///< as a SLAM reports them
  Pose T_map_base_true;  ///< half way between the first and the last beam
};
using Lines = std::vector<Line>;

/// Lines that begin within [from, to).
Lines drive(const World& world, const Motion& motion, double from_s, double to_s,
            const Laser& laser = {});

/// Every `stride`-th true pose, at the lines' middle times.
std::vector<StampedPose> true_trajectory(const Lines& lines, std::size_t stride = 1);

/// The same lines (thus the same ribbons) with the true acquisition poses.
Lines with_true_acquisition_poses(Lines lines);

Modeler model_of(const Lines& lines, const ModelerConfig& config = {});

}  // namespace ribbon_mapper::mini_world
