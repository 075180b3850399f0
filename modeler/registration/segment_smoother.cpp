// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/segment_smoother.hpp"

namespace ribbon_mapper {
namespace {

/// Anywhere, by any scale of a room.
PoseBelief end_at(const std::optional<Pose>& pose, const Pose& otherwise) {
  if (pose) return {*pose, Matrix6::Zero()};
  return {otherwise, 100.0 * Matrix6::Identity()};
}

}  // namespace

Bridge::Bridge(const std::vector<Pose>& steps, const OdometryNoise& noise,
               const std::optional<Pose>& first_end, const std::optional<Pose>& second_end)
    : steps_(steps), ahead_(steps.size() - 1), behind_(steps.size() - 1) {
  Pose T_first_second = Pose::Identity();
  for (const Pose& step : steps_) {
    T_first_second = T_first_second * step;
    variances_.push_back(noise.variances(step));
  }
  const Pose origin = Pose::Identity();
  first_end_ =
      end_at(first_end, second_end.value_or(origin) * T_first_second.inverse(Eigen::Isometry));
  second_end_ = end_at(second_end, first_end.value_or(origin) * T_first_second);
  forth(nullptr);
  back(nullptr);
}

void Bridge::sweep(const Observe& observe) {
  forth(&observe);
  back(&observe);
}

void Bridge::forth(const Observe* observe) {
  PoseBelief belief = first_end_;
  for (std::size_t line = 0; line < lines(); ++line) {
    belief = after_step(belief, steps_[line], variances_[line]);
    ahead_[line] = belief;
    if (observe) belief = updated(belief, (*observe)(line, without(line)));
  }
}

void Bridge::back(const Observe* observe) {
  PoseBelief belief = second_end_;
  for (std::size_t line = lines(); line-- > 0;) {
    belief = before_step(belief, steps_[line + 1], variances_[line + 1]);
    behind_[line] = belief;
    if (observe) belief = updated(belief, (*observe)(line, without(line)));
  }
}

}  // namespace ribbon_mapper
