// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/modeler_config.hpp"
#include "modeler/observations/observations.hpp"
#include "modeler/ribbon/ribbon.hpp"
#include "modeler/scan/scan_front_end.hpp"
#include "modeler/surface/plane_model.hpp"

namespace ribbon_mapper {

/// Counts of what a modeler has done.
struct ModelStatistics {
  std::size_t lines = 0;             ///< lines given to add_scan_line()
  std::size_t ribbons = 0;           ///< ribbons in the model
  std::size_t thinned = 0;           ///< ribbons removed because of ObservationsConfig::max_ribbons
  std::size_t revision = 0;          ///< corrections applied
  std::size_t associated_again = 0;  ///< ribbons that these corrections have associated again
  std::optional<NoReturnRange> no_return;  ///< a range that the driver reports for no return
};

/// A model at rest: all that decides what becomes of it, without its configuration.
struct SavedModel {
  Observations observations;              ///< ribbons, unassigned points and trajectory
  ScanFrontEnd::Parts waiting{};          ///< lines that wait for their neighbours
  std::vector<std::int64_t> plane_ids{};  ///< Modeler::plane_ids(), one for each ribbon
  std::int64_t next_plane_id = 0;         ///< of the next new plane; above all `plane_ids`
  std::size_t lines = 0;                  ///< ModelStatistics::lines
  std::size_t thinned = 0;                ///< ModelStatistics::thinned
  std::size_t revision = 0;               ///< ModelStatistics::revision
  std::size_t associated_again = 0;       ///< ModelStatistics::associated_again
};

/// Builds planes from the lines of a tilting laser, and keeps them right when the trajectory is
/// corrected.
///
/// The model is a function of its observations: ribbons, each in the frame of its acquisition pose,
/// and the trajectory. It is deterministic: there is no thread, no clock and no global state.
class Modeler {
 public:
  /// Creates an empty model. Throws std::invalid_argument with the key and its range if a value of
  /// the configuration is out of range.
  explicit Modeler(const ModelerConfig& config);

  /// Goes on from a saved model. With the configuration that it was saved with, it takes
  /// corrections and lines as the model that was never saved, with the same results to the byte.
  /// Any other configuration holds for all but the ribbons that are there. Lines that are not later
  /// than the saved ones are out of order; see ScanFrontEnd for a pause before the next one. Takes
  /// as long as a correction. Throws std::invalid_argument as the other constructor.
  Modeler(const ModelerConfig& config, SavedModel saved);
  ~Modeler();
  Modeler(Modeler&&) noexcept;
  Modeler& operator=(Modeler&&) noexcept;

  /// Adds a scan line: buffer, surfels, ribbons and association (sections 4.1 to 4.3 of the paper).
  ///
  /// Returns what became of the line, and never throws because of bad data. After std::bad_alloc,
  /// the line may be in the model in part: reset() or destroy the modeler. When the model exceeds
  /// ObservationsConfig::max_ribbons, it is thinned by an eighth and evaluated again.
  LineResult add_scan_line(const LaserBeams& beams, const LinePoses& poses);

  /// Replaces the trajectory by a corrected one and evaluates the model again (section 4.4).
  ///
  /// The poses are those of base_footprint in map, with strictly ascending stamps; they are taken
  /// as exact. Between them the robot moved as its odometry says, and the drift is interpolated in
  /// SE(3). Where that leaves ribbons in doubt (with a pose every metre rather than every line),
  /// lines are registered to planes; see registered_poses(). Before the first and after the last
  /// corrected pose the nearest change applies.
  ///
  /// Each correction replaces the one before: changes are always measured from the recorded poses.
  /// TrajectoryConfig::poses_follow tells how later lines are placed. A correction takes about 0.1
  /// s for 100 s of recording, and ten times that if lines must be registered. One that leaves the
  /// first lines where they are takes as long as its share of the ribbons, with the same result.
  ///
  /// Throws std::invalid_argument if the trajectory is empty or unordered, a pose has a defect, or
  /// it does not overlap the model in time. The model is then unchanged, as after any exception.
  void correct(const std::vector<StampedPose>& corrected_trajectory);

  /// Removes all observations and starts an empty model.
  void reset();

  /// Computes the planes as they were aggregated on the way (after correct(): as evaluated again).
  /// They are in map, ordered by id, without outlines. Takes about as long as planes().
  std::vector<Plane> planes_as_built() const;

  /// Computes the planes of the model: merged, filtered and with their outlines, in map, ordered by
  /// id. Takes about 20 ms for 100 s of recording.
  std::vector<Plane> planes() const;

  /// Computes the planes as planes() does, and which ribbons are of things that are gone.
  PlaneModel plane_model() const;

  /// Returns the acquisition poses as they are now, one for each line in the model, with strictly
  /// ascending stamps. A line of which no ribbon is left has left the model.
  std::vector<StampedPose> trajectory() const;

  /// Returns all ribbons in the order of their lines and beams, each in the frame of its
  /// acquisition pose: trajectory()[ribbon.pose]. Valid until the model changes.
  const std::vector<Ribbon>& ribbons() const;

  /// Returns all that the model is a function of. The reference is valid until reset() or a move.
  const Observations& observations() const;

  /// Returns the lines that wait for their neighbours, and what earlier ones have shown.
  ScanFrontEnd::Parts waiting() const;

  /// Returns the configuration.
  const ModelerConfig& config() const;

  /// Returns the id of the plane, as built, that each ribbon belongs to. Visits every hypothesis.
  std::vector<std::int64_t> plane_ids() const;

  /// Returns the id that the next new plane will have.
  std::int64_t next_plane_id() const;

  /// Returns counts of what has been done.
  ModelStatistics statistics() const;

  /// Computes the memory in use by observations and hypotheses [bytes]. Visits every hypothesis.
  std::size_t memory_bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ribbon_mapper
