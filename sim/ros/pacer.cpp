// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/ros/pacer.hpp"

#include <thread>

namespace ribbon_mapper::sim {
namespace {
constexpr std::chrono::milliseconds kMaxToCatchUp{100};
constexpr double kWatch_s = 5.0;
}  // namespace

double Pacer::seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

void Pacer::wait_until(Time now) {
  now_ = now;
  const Clock::time_point wall = Clock::now();
  if (!start_) start_ = Moment{wall, now};
  const auto due = start_->wall +
                   std::chrono::duration_cast<Clock::duration>(
                       std::chrono::duration<double>(to_seconds(now - start_->simulated) / rate_));
  if (wall - due > kMaxToCatchUp) start_ = Moment{wall - kMaxToCatchUp, now};
  std::this_thread::sleep_until(due);
}

std::optional<double> Pacer::shortfall() {
  const Moment here{Clock::now(), now_};
  if (!watched_) watched_ = here;
  const double wall_s = seconds_between(watched_->wall, here.wall);
  if (wall_s < kWatch_s) return std::nullopt;
  const double reached = to_seconds(here.simulated - watched_->simulated) / wall_s;
  watched_ = here;
  if (reached > 0.95 * rate_) return std::nullopt;
  return reached;
}

}  // namespace ribbon_mapper::sim
