// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <optional>

#include "modeler/geometry/time.hpp"

namespace ribbon_mapper::sim {

/// Makes simulated time pass at a multiple of real time.
class Pacer {
 public:
  /// `rate`: simulated seconds per second.
  explicit Pacer(double rate) : rate_(rate) {}

  /// Sleeps until simulated time `now` is due. Catches up with a delay of up to 0.1 s; a longer
  /// delay is accepted, so that subscribers are not flooded.
  void wait_until(Time now);

  /// Returns the rate of the last 5 s if it fell short of the requested one by more than 5 %.
  /// Returns nothing in between.
  std::optional<double> shortfall();

 private:
  using Clock = std::chrono::steady_clock;
  struct Moment {
    Clock::time_point wall;
    Time simulated;
  };
  static double seconds_between(Clock::time_point from, Clock::time_point to);

  double rate_;
  std::optional<Moment> start_, watched_;
  Time now_{0};
};

}  // namespace ribbon_mapper::sim
