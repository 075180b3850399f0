// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/geometry/packed_poses.hpp"
#include "modeler/geometry/pose.hpp"
#include "modeler/trajectory/correction.hpp"
#include "modeler/trajectory/trajectory_config.hpp"

namespace ribbon_mapper {

/// Acquisition poses: as they were recorded, and where they are believed to be now. Every
/// correction is measured from the recorded ones.
class Trajectory {
 public:
  explicit Trajectory(const CorrectionConfig& config) : config_(config) {}

  /// Stamps must increase.
  void add(const TrackedPose& recorded);

  /// Throws as Correction does; the trajectory is then as it was.
  void correct(const std::vector<StampedPose>& corrected);

  /// Leaves out all poses but these, in order.
  void keep(const std::vector<std::uint32_t>& indices);

  /// Takes over the poses of all lines, registered between the corrected ones; stamps as they are.
  void refine(const std::vector<StampedPose>& poses);

  std::size_t size() const { return recorded_.size(); }
  /// As it is now.
  Pose T_map_base(std::size_t index) const;
  std::vector<StampedPose> poses() const;
  const TrackedPoses& recorded() const { return recorded_; }
  /// The corrected poses within the time of the model, with their odometry; only if is_corrected().
  const TrackedPoses& corrected() const { return correction_->poses(); }
  bool is_corrected() const { return correction_.has_value(); }
  std::size_t memory_bytes() const;

 private:
  CorrectionConfig config_;
  TrackedPoses recorded_;
  PackedPoses T_map_base_;  // empty before the first correction
  std::optional<Correction> correction_;
};

}  // namespace ribbon_mapper
