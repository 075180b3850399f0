// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "modeler/modeler.hpp"

/// A world of a few faces whose ranges are known in closed form, and a robot that drives through it
/// with a laser: the ground truth of the modeler's tests. It shares no code with sim/.
namespace ribbon_mapper::mini_world {

/// The part of the plane normal.p + d = 0 that lies in a box, in map. It is visible from both
/// sides.
struct Face {
  Eigen::Vector3d normal;      ///< unit normal
  double d_m;                  ///< d
  Eigen::AlignedBox3d bounds;  ///< the box
};

/// The faces that the laser sees.
using World = std::vector<Face>;

/// Returns an unbounded face.
Face plane(const Eigen::Vector3d& normal, double d_m);
/// Returns a face that is bounded by the box between two corners.
Face plane(const Eigen::Vector3d& normal, double d_m, const Eigen::Vector3d& min_corner,
           const Eigen::Vector3d& max_corner);

/// Returns the six faces of a room of 6 x 5 x 2.5 m. The middle of its floor is the origin, and the
/// normals point inwards.
World room();

/// Returns the distance to the nearest face [m], or infinity if there is none.
double range_m(const World& world, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction);

/// A pose as a function of time.
using PoseByTime = std::function<Pose(double time_s)>;
/// An angle as a function of time.
using AngleByTime = std::function<double(double time_s)>;

/// The motion of robot and laser, and the errors of localisation.
struct Motion {
  PoseByTime T_map_base;  ///< true pose of the robot
  AngleByTime tilt_rad;   ///< tilt of the laser; positive is downwards
  PoseByTime drift;       ///< the pose that a SLAM reports is drift * truth
};

/// Returns the identity.
Pose no_drift(double time_s);
/// Returns a drift that grows to 0.3 m and 4 degrees within 15 s.
Pose wandering_drift(double time_s);
/// Returns a tilt that goes up and down between +-1.2 rad at a constant speed of 0.8 rad/s.
double to_and_fro(double time_s);
/// Returns a pose on a circle of 0.6 m radius through the origin, which is driven once in 15 s.
Pose around_the_middle(double time_s);

/// Returns the motion of a robot that stands at the origin and tilts its laser up and down.
Motion tilting_in_place();

/// A laser 1.2 m above the base that covers 180 degrees. It takes 40 lines per second, each within
/// 18.5 ms.
struct Laser {
  std::size_t beams = 361;       ///< beams of a line
  double range_sigma_m = 0.005;  ///< standard deviation of a range
  unsigned seed = 1;             ///< seed of the noise
};

/// Returns the pose of the laser at a tilt.
Pose T_base_laser(double tilt_rad);

/// A scan line with its true pose.
struct Line {
  LaserBeams beams;      ///< ranges with noise
  LinePoses poses;       ///< poses with drift, as a SLAM reports them
  Pose T_map_base_true;  ///< true pose at the middle of the line
};

/// Lines in the order of their stamps.
using Lines = std::vector<Line>;

/// Returns the lines that begin within [from_s, to_s).
Lines drive(const World& world, const Motion& motion, double from_s, double to_s,
            const Laser& laser = {});

/// Returns the true pose of every `stride`-th line, at the middle of the line.
std::vector<StampedPose> true_trajectory(const Lines& lines, std::size_t stride = 1);

/// Returns the same lines, which make the same ribbons, with their true acquisition poses.
Lines with_true_acquisition_poses(Lines lines);

/// Returns a modeler to which all lines were given.
Modeler model_of(const Lines& lines, const ModelerConfig& config = {});

}  // namespace ribbon_mapper::mini_world
