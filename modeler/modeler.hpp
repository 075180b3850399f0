// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/modeler_config.hpp"
#include "modeler/ribbon/ribbon.hpp"
#include "modeler/scan/laser_beams.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// What became of a scan line.
enum class LineResult {
  modelled,      ///< it entered the buffer, ribbons of the line before it are in the model
  too_close,     ///< it has hardly moved since the line before it: it would add noise only
  no_returns,    ///< not a single valid range
  malformed,     ///< wrong length, or angles, times or poses that are not finite
  out_of_order,  ///< stamped before the line before it
};

const char* to_string(LineResult result);

struct ModelStatistics {
  std::size_t lines = 0;     ///< given to add_scan_line()
  std::size_t ribbons = 0;   ///< in the model
  std::size_t thinned = 0;   ///< ribbons that were left out for PlaneMapConfig::max_ribbons
  std::size_t revision = 0;  ///< number of corrections applied
};

/// Planes from the lines of a tilting laser; the model follows every correction of the trajectory.
///
/// The model is a function of two things: the ribbons, each kept in the frame of its acquisition
/// pose, and the trajectory. Deterministic: no thread, no clock, no global.
class Modeler {
 public:
  /// Throws std::invalid_argument that names the key and its range if a value is out of range.
  explicit Modeler(const ModelerConfig& config);
  ~Modeler();
  Modeler(Modeler&&) noexcept;
  Modeler& operator=(Modeler&&) noexcept;

  /// Sections 4.1 to 4.3 of the paper: buffer, surfels, ribbons, association. Never throws on bad
  /// data: the result says what became of the line. When the model has
  /// PlaneMapConfig::max_ribbons, an eighth of them is left out, where they are densest, and the
  /// model evaluated again.
  LineResult add_scan_line(const LaserBeams& beams, const LinePoses& poses);

  /// Section 4.4: takes over a corrected trajectory (base_footprint in map, stamps strictly
  /// increasing) and evaluates the model again. Corrected poses are exact. Between them the robot
  /// went as its odometry says, the drift in between is interpolated in SE(3); where that leaves
  /// ribbons in doubt (a pose every metre, not at every line), lines are registered against the
  /// planes of those that are not, see registered_poses(). Before the first and after the last
  /// corrected pose, the nearest change holds, and the lines of up to one such gap are registered
  /// from that end. Each revision replaces the one before: changes are always measured from the
  /// poses that lines came with.
  /// Takes about 0.1 s for each 100 s of recording, ten times that if lines must be registered.
  /// Later lines: see CorrectionConfig::poses_follow.
  /// Throws std::invalid_argument if the trajectory is empty, out of order, not finite, or does
  /// not overlap in time with the model's; the model is then as it was.
  void correct(const std::vector<StampedPose>& corrected_trajectory);

  void reset();

  /// Confirmed planes as built on the way (or, after correct(), as evaluated again).
  std::vector<Plane> planes_as_built() const;

  /// The same after the final merging and filtering of small planes.
  std::vector<Plane> planes() const;

  /// Acquisition poses as they are now (corrected if there was a correction), one per line in
  /// the model, stamps strictly increasing. A line of which no ribbon was kept has left it.
  std::vector<StampedPose> trajectory() const;

  /// All ribbons in the order of their lines and beams, each in the frame of its acquisition pose,
  /// which is the one of that index in trajectory(). Valid until the model changes.
  const std::vector<Ribbon>& ribbons() const;

  ModelStatistics statistics() const;

  /// Of ribbons, trajectory and hypotheses; takes a while.
  std::size_t memory_bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ribbon_mapper
