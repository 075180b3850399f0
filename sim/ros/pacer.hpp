// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <optional>

#include "modeler/geometry/time.hpp"

namespace ribbon_mapper::sim {

/// Lets simulated time pass at a multiple of real time.
class Pacer {
 public:
  explicit Pacer(double rate) : rate_(rate) {}

  /// Sleeps until it is `now` in the simulation. What was lost by up to 0.1 s is caught up with;
  /// more is given up, so that nobody is flooded.
  void wait_until(Time now);

  /// The rate of the last seconds, if it fell short of the one asked for by more than 5 %. Asked
  /// every few seconds.
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
