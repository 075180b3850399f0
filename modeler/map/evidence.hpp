// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/geometry/pose.hpp"
#include "modeler/map/posed_ribbon.hpp"

namespace ribbon_mapper {

/// All that a model is made of: the ribbons and the poses that they were acquired from. The model
/// is evaluated in a world that is fixed to the first acquisition pose, so a trajectory that is
/// moved as a whole moves every plane by just that.
class Evidence {
 public:
  Evidence(const std::vector<Ribbon>& ribbons, const std::vector<StampedPose>& poses)
      : ribbons_(&ribbons), poses_(&poses) {}

  std::size_t size() const { return ribbons_->size(); }
  Pose T_map_world() const { return poses_->front().T_map_base; }

  PosedRibbon ribbon(std::size_t index) const {
    const Ribbon& ribbon = (*ribbons_)[index];
    const Pose T_world_map = T_map_world().inverse(Eigen::Isometry);
    return {ribbon, T_world_map * (*poses_)[ribbon.pose].T_map_base};
  }

 private:
  const std::vector<Ribbon>* ribbons_;
  const std::vector<StampedPose>* poses_;
};

}  // namespace ribbon_mapper
