// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "modeler/observations/posed_observations.hpp"
#include "modeler/ribbon/line_observations.hpp"
#include "modeler/ribbon/packed_store.hpp"
#include "modeler/trajectory/trajectory.hpp"

namespace ribbon_mapper {

/// All that a model is a function of: the ribbons and unassigned points, each in the frame of its
/// acquisition pose, and the trajectory of these poses.
///
/// Nothing here is in world coordinates, so nothing has to be edited when the trajectory changes:
/// the model is evaluated again. Every operation keeps lines, poses and ribbons in step.
class Observations {
 public:
  /// Creates observations without lines.
  explicit Observations(const TrajectoryConfig& config) : trajectory_(config) {}

  /// What observations consist of. Ribbons and unassigned points refer to the two stores, and by
  /// their members `pose` to the trajectory; there is one element of `unassigned` for each pose.
  struct Parts {
    Trajectory trajectory;                     ///< acquisition poses
    std::vector<Ribbon> ribbons;               ///< in the order of their lines and beams
    std::vector<UnassignedPoints> unassigned;  ///< by pose
    PackedStore<PackedSample> samples;         ///< of the ribbons
    PackedStore<PackedPoint> points;           ///< of the unassigned points
  };
  /// Creates the observations of these parts.
  explicit Observations(Parts parts);

  /// Adds a line with its acquisition pose, whose stamp must be later than that of the last line.
  /// Copies what `line` refers to, and returns the index of its first ribbon. If memory runs out,
  /// the observations are unchanged.
  std::uint32_t add_line(const TrackedPose& pose, const LineObservations& line);

  /// Corrects the trajectory. Throws std::invalid_argument as Trajectory::correct() does; the
  /// observations are then unchanged.
  void correct(const std::vector<StampedPose>& corrected) { trajectory_.correct(corrected); }

  /// Replaces the trajectory by one of the same lines.
  void move_to(Trajectory trajectory) { trajectory_ = std::move(trajectory); }

  /// Removes ribbons where the same surface was seen most often, until `count` of them are left,
  /// and lines that no remaining ribbon came from. Returns the ascending former indices of the
  /// remaining ribbons; see thinned(). If memory runs out, the observations are unchanged.
  std::vector<std::uint32_t> thin(std::size_t count);

  /// Returns all ribbons in the order of their lines and beams. Ribbon::pose indexes trajectory().
  const std::vector<Ribbon>& ribbons() const { return ribbons_; }
  /// Returns the index of the first ribbon of a line or of the next one that has ribbons.
  std::uint32_t first_ribbon_of(std::size_t line) const;
  /// Returns the unassigned points, one element for each pose of trajectory().
  const std::vector<UnassignedPoints>& unassigned() const { return unassigned_; }
  /// Returns the acquisition poses.
  const Trajectory& trajectory() const { return trajectory_; }
  /// Returns an acquisition pose in the model's frame: relative to the first acquisition pose.
  Pose T_model_base(std::size_t pose) const {
    return trajectory_.T_map_base(0).inverse(Eigen::Isometry) * trajectory_.T_map_base(pose);
  }
  /// Returns all observations at the poses of now. Unpacks every pose; valid until they change.
  PosedObservations posed() const { return posed_at(trajectory_); }
  /// Returns all observations at other poses of the same lines, as posed().
  PosedObservations posed_at(const Trajectory& trajectory) const {
    return {ribbons_, unassigned_, trajectory.poses()};
  }
  /// Returns the memory in use.
  std::size_t memory_bytes() const;

 private:
  void compact_storage(const std::vector<std::uint32_t>& ribbons,
                       const std::vector<std::uint32_t>& lines);

  std::vector<Ribbon> ribbons_;
  std::vector<UnassignedPoints> unassigned_;  // by pose
  Trajectory trajectory_;
  PackedStore<PackedSample> samples_;  // of the ribbons
  PackedStore<PackedPoint> points_;    // of the unassigned points
};

}  // namespace ribbon_mapper
