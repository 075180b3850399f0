// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "modeler/association/association_config.hpp"
#include "modeler/modeler.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// How ribbons of one plane deviate from it (section 5.1): V_sensor while the robot stands, V_slam
/// while it moves.
struct RibbonDeviation {
  std::size_t ribbons = 0;               ///< number of ribbons that were measured
  double distance_variance_m2 = 0.0;     ///< mean square of points' distances from the plane [m2]
  double scalar_product_variance = 0.0;  ///< of the ribbons' normals with the plane's normal
  double angle_variance_rad2 = 0.0;      ///< mean square of the angles between them [rad2]

  /// Gates that hold this deviation. The paper takes a threshold at or above the largest error;
  /// here three standard deviations.
  AssociationGates tolerance{0.0, 0.0};
};

/// The result of a calibration.
struct Calibration {
  Plane plane;              ///< the plane ahead of the robot, in map
  RibbonDeviation stopped;  ///< V_sensor
  RibbonDeviation moving;   ///< V_slam
  double travel_m = 0.0;    ///< distance travelled by odometry [m]
  double turn_deg = 0.0;    ///< sum of the absolute rotations by odometry [deg]
};

/// Learns the tolerances of a robot and its localisation as in section 5.1 of the paper.
///
/// The robot stands before a large plane that it faces, then moves 3 to 5 m in front of it, with
/// translations and rotations. Lines before the first motion count as stopped; all of them are
/// placed at the first one's pose, whatever the localisation says. Later lines count as moving.
class Calibrator {
 public:
  /// Throws std::invalid_argument if a value of the configuration is out of its range.
  explicit Calibrator(const ModelerConfig& config) : modeler_(config) {}

  /// Adds a scan line, in order of time. Lines with a defect are ignored.
  void add(const LaserBeams& beams, const LinePoses& poses);

  /// Returns the distance travelled so far by odometry [m].
  double travel_m() const { return travel_m_; }
  /// Returns the number of lines before the first motion.
  std::size_t lines_stopped() const { return lines_stopped_; }
  /// Returns true if the robot has stood for enough lines.
  bool has_rested() const;

  /// Returns the calibration. Throws std::runtime_error that says what is missing: motion, time at
  /// rest, a plane ahead, or ribbons on it.
  Calibration result() const;

 private:
  void follow(const LinePoses& poses, double line_s);
  RibbonDeviation deviation(const Plane& plane, std::size_t first_ribbon,
                            std::size_t end_ribbon) const;

  Modeler modeler_;
  std::optional<Pose> T_map_standing_;
  std::optional<Pose> T_odom_base_;  // where travel and rotation were counted last
  bool has_moved_ = false;
  std::size_t lines_stopped_ = 0, ribbons_stopped_ = 0;
  std::vector<Plane> planes_stopped_;
  double travel_m_ = 0.0, turn_rad_ = 0.0;
};

/// Returns the configuration with the learned tolerances, limited to the allowed ranges. Those of
/// the moving robot become the gates for poses of a SLAM. Those of the standing robot are a lower
/// bound of the gates after a correction: ribbons acquired in motion may need wider ones.
ModelerConfig with_tolerances(ModelerConfig config, const Calibration& calibration);

/// Returns the variances and tolerances beside those of the paper, as a table for a terminal.
std::string calibration_table(const Calibration& calibration);

}  // namespace ribbon_mapper
