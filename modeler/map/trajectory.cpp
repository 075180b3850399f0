// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/trajectory.hpp"

#include <stdexcept>

namespace ribbon_mapper {

void Trajectory::add(const RecordedPose& recorded) {
  recorded_.push_back(recorded);
  current_.push_back(recorded.in_map);
  if (correction_ && !config_.poses_follow) {
    current_.back().T_map_base = correction_->corrected(recorded);
  }
}

void Trajectory::correct(const std::vector<StampedPose>& corrected) {
  if (recorded_.empty()) throw std::invalid_argument("there is no model to correct yet");
  correction_.emplace(recorded_, corrected);
  for (std::size_t i = 0; i < recorded_.size(); ++i) {
    current_[i].T_map_base = correction_->corrected(recorded_[i]);
  }
}

}  // namespace ribbon_mapper
