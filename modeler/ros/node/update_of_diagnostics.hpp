// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

namespace ribbon_mapper {

/// Publishes what an updater reports now, unless the clock is so near to its end that the time of
/// the next report cannot be told: diagnostic_updater throws then.
inline void publish_now(diagnostic_updater::Updater& updater) {
  constexpr double kMaxPeriod_s = 3600.0;
  if (ros::Time::now().toSec() + kMaxPeriod_s < ros::TIME_MAX.toSec()) updater.force_update();
}

}  // namespace ribbon_mapper
