// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ribbon_mapper {

/// How a corrected trajectory affects the lines that follow it.
struct TrajectoryConfig {
  /// True: the SLAM corrects its tf together with the trajectory, so later lines are placed where
  /// tf says. False: tf continues as if nothing had happened (as a SLAM does that closes no
  /// loops, and as the simulator's does), so the last change is applied to later lines as well.
  bool poses_follow = true;
};

}  // namespace ribbon_mapper
