// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/observations/posed_ribbon.hpp"
#include "modeler/ribbon/unassigned_points.hpp"

namespace ribbon_mapper {

/// Ribbons and unassigned points at the acquisition poses of one evaluation of the model.
///
/// Poses are unpacked once for all queries. They are relative to the first acquisition pose, whose
/// frame is called `model`: a trajectory that is moved as a whole moves every plane by exactly the
/// same transform. Ribbons and points must outlive this object.
class PosedObservations {
 public:
  /// Poses ribbons and unassigned points at `poses`, which their members `pose` index. There is one
  /// element of `unassigned` for each pose.
  PosedObservations(const std::vector<Ribbon>& ribbons,
                    const std::vector<UnassignedPoints>& unassigned,
                    const std::vector<StampedPose>& poses)
      : ribbons_(&ribbons), unassigned_(&unassigned) {
    if (poses.empty()) return;
    T_map_model_ = poses.front().T_map_base;
    const Pose T_model_map = T_map_model_.inverse(Eigen::Isometry);
    T_model_base_.reserve(poses.size());
    for (const StampedPose& pose : poses) T_model_base_.emplace_back(T_model_map * pose.T_map_base);
  }

  /// Returns the pose of the model's frame in map: the first acquisition pose.
  const Pose& T_map_model() const { return T_map_model_; }
  /// Returns the acquisition pose at index `pose`, in the model's frame.
  const Pose& T_model_base(std::uint32_t pose) const { return T_model_base_[pose]; }

  /// Returns the number of ribbons.
  std::size_t ribbon_count() const { return ribbons_->size(); }
  /// Returns a ribbon in the frame of its acquisition pose.
  const Ribbon& source(std::size_t index) const { return (*ribbons_)[index]; }
  /// Returns a ribbon in the model's frame.
  PosedRibbon ribbon(std::size_t index) const {
    const Ribbon& ribbon = source(index);
    return {ribbon, T_model_base(ribbon.pose)};
  }
  /// Returns the samples of a ribbon in the model's frame.
  PosedSamples samples(std::size_t index) const {
    const Ribbon& ribbon = source(index);
    return {ribbon, T_model_base(ribbon.pose)};
  }
  /// Prefetches the samples of ribbon `index` and the ribbon `later`. Both are scattered in memory
  /// and will be read shortly.
  void prefetch(std::size_t index, std::size_t later) const {
    prefetch_lines<sizeof(Ribbon)>(&source(later));
    prefetch_lines<64 * sizeof(PackedSample)>(source(index).samples.first);
  }

  /// Returns the unassigned points of all lines, by pose.
  const std::vector<UnassignedPoints>& unassigned() const { return *unassigned_; }

 private:
  template <std::size_t bytes>
  static void prefetch_lines(const void* memory) {
    constexpr std::size_t kCacheLine = 64;
    for (std::size_t i = 0; i < bytes; i += kCacheLine) {
      __builtin_prefetch(static_cast<const char*>(memory) + i);
    }
  }

  const std::vector<Ribbon>* ribbons_;
  const std::vector<UnassignedPoints>* unassigned_;
  Pose T_map_model_ = Pose::Identity();
  std::vector<Pose> T_model_base_;
};

}  // namespace ribbon_mapper
