// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/observations/posed_ribbon.hpp"
#include "modeler/ribbon/unassigned_points.hpp"

namespace ribbon_mapper {

/// All that a model is made of: the ribbons, the points that belong to none, and the poses that
/// they were acquired from. The model is evaluated in a world that is fixed to the first
/// acquisition pose, so a trajectory that is moved as a whole moves every plane by just that.
class Observations {
 public:
  Observations(const std::vector<Ribbon>& ribbons, const std::vector<UnassignedPoints>& unassigned,
               const std::vector<StampedPose>& poses)
      : ribbons_(&ribbons), unassigned_(&unassigned) {
    if (poses.empty()) return;
    T_map_model_ = poses.front().T_map_base;
    const Pose T_model_map = T_map_model_.inverse(Eigen::Isometry);
    T_model_base_.reserve(poses.size());
    for (const StampedPose& pose : poses) T_model_base_.emplace_back(T_model_map * pose.T_map_base);
  }

  const Pose& T_map_model() const { return T_map_model_; }
  const Pose& T_model_base(std::uint32_t pose) const { return T_model_base_[pose]; }

  std::size_t ribbon_count() const { return ribbons_->size(); }
  const Ribbon& source(std::size_t index) const { return (*ribbons_)[index]; }
  PosedRibbon ribbon(std::size_t index) const {
    const Ribbon& ribbon = source(index);
    return {ribbon, T_model_base(ribbon.pose)};
  }
  PosedSamples samples(std::size_t index) const {
    const Ribbon& ribbon = source(index);
    return {ribbon, T_model_base(ribbon.pose)};
  }
  /// Somebody will ask for samples(index) very soon, for those of `later` soon: ribbons and their
  /// samples lie all over the memory, and are fetched meanwhile.
  void prefetch(std::size_t index, std::size_t later) const {
    prefetch_lines<sizeof(Ribbon)>(&source(later));
    prefetch_lines<64 * sizeof(PackedSample)>(source(index).samples.first);
  }

  std::size_t unassigned_lines() const { return unassigned_->size(); }
  const UnassignedPoints& unassigned(std::size_t line) const { return (*unassigned_)[line]; }

 private:
  template <std::size_t bytes>
  static void prefetch_lines(const void* memory) {
    constexpr std::size_t line = 64;
    for (std::size_t i = 0; i < bytes; i += line) {
      __builtin_prefetch(static_cast<const char*>(memory) + i);
    }
  }

  const std::vector<Ribbon>* ribbons_;
  const std::vector<UnassignedPoints>* unassigned_;
  Pose T_map_model_ = Pose::Identity();
  std::vector<Pose> T_model_base_;
};

}  // namespace ribbon_mapper
