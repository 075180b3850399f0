// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "modeler/geometry/packed_poses.hpp"
#include "modeler/geometry/pose.hpp"
#include "modeler/trajectory/correction.hpp"
#include "modeler/trajectory/trajectory_config.hpp"

namespace ribbon_mapper {

/// The acquisition poses of all lines: as they were recorded, and as they are now. Every correction
/// is measured from the recorded ones, so that corrections do not accumulate errors. Copies share
/// the recorded poses until a line is added or removed; they must stay within one thread.
class Trajectory {
 public:
  /// Creates an empty trajectory.
  explicit Trajectory(const TrajectoryConfig& config)
      : config_(config), recorded_(std::make_shared<TrackedPoses>()) {}

  /// What a trajectory is made of.
  struct Parts {
    TrackedPoses recorded;                 ///< see recorded()
    PackedPoses now;                       ///< one for each recorded pose; empty: not corrected
    std::optional<Correction> correction;  ///< the last one, if `now` is not empty
    bool is_as_corrected = false;          ///< see Trajectory::is_as_corrected()
  };
  /// Creates the trajectory of these parts.
  Trajectory(const TrajectoryConfig& config, Parts parts);

  /// Makes room for one more pose: the next add() cannot fail.
  void reserve_one_more();

  /// Appends a recorded pose, moved by the last correction unless TrajectoryConfig::poses_follow.
  /// Its stamp must be later than that of the last one.
  void add(const TrackedPose& recorded);

  /// Replaces the previous correction by a new one. Throws std::invalid_argument as Correction
  /// does, or if there are no poses yet; the trajectory is then unchanged.
  void correct(const std::vector<StampedPose>& corrected);

  /// Replaces the poses of all lines, registered between the corrected ones. There is one pose for
  /// each line, with its stamp.
  void refine(const std::vector<StampedPose>& poses);

  /// Keeps only the poses at these ascending indices.
  void keep(const std::vector<std::uint32_t>& indices);

  /// Returns the number of poses.
  std::size_t size() const { return recorded_->size(); }
  /// Returns the pose at `index` as it is now.
  Pose T_map_base(std::size_t index) const;
  /// Returns all poses as they are now.
  std::vector<StampedPose> poses() const;
  /// Returns the number of the first poses that are those of `other`, bit by bit.
  std::size_t common_with(const Trajectory& other) const;
  /// Returns all poses as they were recorded.
  const TrackedPoses& recorded() const { return *recorded_; }
  /// Returns true if the trajectory has been corrected.
  bool is_corrected() const { return correction_ != nullptr; }
  /// Returns the corrected poses within the time of the trajectory, with their odometry. Needs
  /// is_corrected().
  const TrackedPoses& corrected() const { return correction_->poses(); }
  /// Returns the poses as they are now, which before the first correction are the recorded ones.
  const PackedPoses& poses_now() const {
    return T_map_base_.empty() ? recorded_->T_map_base() : T_map_base_;
  }
  /// Returns the last correction, or null.
  const Correction* correction() const { return correction_.get(); }
  /// Returns true if all poses are what the last correction says of the recorded ones.
  bool is_as_corrected() const { return is_as_corrected_; }
  /// Returns the memory in use.
  std::size_t memory_bytes() const;

 private:
  TrackedPoses& own_recorded();

  TrajectoryConfig config_;
  std::shared_ptr<TrackedPoses> recorded_;
  PackedPoses T_map_base_;  // empty before the first correction
  std::shared_ptr<const Correction> correction_;
  bool is_as_corrected_ = false;
};

}  // namespace ribbon_mapper
