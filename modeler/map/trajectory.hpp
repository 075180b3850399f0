// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/map/correction.hpp"
#include "modeler/map/correction_config.hpp"

namespace ribbon_mapper {

/// Acquisition poses: as they were recorded, and where they are believed to be now. Every
/// correction is measured from the recorded ones.
class Trajectory {
 public:
  explicit Trajectory(const CorrectionConfig& config) : config_(config) {}

  /// Stamps must increase.
  void add(const RecordedPose& recorded);

  /// Throws as Correction does; the trajectory is then as it was.
  void correct(const std::vector<StampedPose>& corrected);

  /// Takes over the poses of all lines, registered between the corrected ones; stamps as they are.
  void refine(std::vector<StampedPose> poses) { current_ = std::move(poses); }

  const std::vector<StampedPose>& poses() const { return current_; }
  const std::vector<RecordedPose>& recorded() const { return recorded_; }
  /// The corrected poses within the time of the model, with their odometry; only if is_corrected().
  const std::vector<RecordedPose>& corrected() const { return correction_->poses(); }
  const StampedPose& recorded(std::size_t index) const { return recorded_[index].in_map; }
  bool is_corrected() const { return correction_.has_value(); }

 private:
  CorrectionConfig config_;
  std::vector<RecordedPose> recorded_;
  std::vector<StampedPose> current_;
  std::optional<Correction> correction_;
};

}  // namespace ribbon_mapper
