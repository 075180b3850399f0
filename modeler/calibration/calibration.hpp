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

/// How ribbons of one plane differ from it (section 5.1): V_sensor while the robot stands, V_slam
/// while it moves.
struct RibbonSpread {
  std::size_t ribbons = 0;
  double distance_variance_m2 = 0.0;     ///< mean square of their points' distances from the plane
  double scalar_product_variance = 0.0;  ///< of the ribbons' normals with the plane's
  double angle_variance_rad2 = 0.0;      ///< mean square of the angles between these
  /// The paper takes a threshold at or above the maximal error: three standard deviations.
  AssociationGates tolerance{0.0, 0.0};
};

/// What a calibration run has learned.
struct Calibration {
  Plane plane;  ///< that the robot stood before
  RibbonSpread stopped, moving;
  double travel_m = 0.0;  ///< by odometry
  double turn_deg = 0.0;  ///< all turns together
};

/// Learns the tolerances of a robot and its localisation as section 5.1 of the paper does: the
/// robot stands before a large plane that it faces, then moves 3 to 5 m in front of it, with
/// translations and rotations. Everything until the robot first moves counts as stopped, and was
/// seen from one pose, whatever the localisation says; all after counts as moving.
class Calibrator {
 public:
  /// Throws std::invalid_argument as Modeler does.
  explicit Calibrator(const ModelerConfig& config) : modeler_(config) {}

  void add(const LaserBeams& beams, const LinePoses& poses);

  double travel_m() const { return travel_m_; }
  std::size_t lines_stopped() const { return lines_stopped_; }
  bool has_rested() const;  ///< long enough

  /// Throws std::runtime_error that says what is missing: time at rest, a plane ahead, motion.
  Calibration result() const;

 private:
  void follow(const LinePoses& poses, double line_s);
  RibbonSpread spread(const Plane& plane, std::size_t first_ribbon, std::size_t end_ribbon) const;

  Modeler modeler_;
  std::optional<Pose> T_map_standing_;
  std::optional<Pose> T_odom_base_;  ///< where travel and turns were counted last
  bool has_moved_ = false;
  std::size_t lines_stopped_ = 0, ribbons_stopped_ = 0;
  std::vector<Plane> planes_stopped_;
  double travel_m_ = 0.0, turn_rad_ = 0.0;
};

/// The preset with the tolerances that were learned, as far as the allowed ranges let them: moving
/// for the poses of a SLAM; stopped as the least for corrected ones, which ribbons that were taken
/// in motion need wider than that.
ModelerConfig with_tolerances(ModelerConfig config, const Calibration& calibration);

/// A table for a terminal, beside that of the paper.
std::string calibration_table(const Calibration& calibration);

}  // namespace ribbon_mapper
