// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/tour/tour.hpp"

#include "sim/robot/pr2.hpp"
#include "sim/robot/stream_seed.hpp"
#include "sim/tour/route_view.hpp"

namespace ribbon_mapper::sim {
namespace {

/// Streams of random numbers.
constexpr std::uint64_t kRangeStream = 0x9e3779b97f4a7c15u;
constexpr std::uint64_t kBaseRangeStream = 0x94d049bb133111ebu;
constexpr std::uint64_t kLocalisationStream = 0xbf58476d1ce4e5b9u;

Time stamp_of_line(std::size_t line, const Hokuyo& hokuyo) {
  return static_cast<Time::rep>(line) * hokuyo.period();
}

/// Returns the number of lines that end within `duration`.
std::size_t lines_within(Time duration, const Hokuyo& hokuyo) {
  const Time room = duration - hokuyo.sweep_time();
  return room < Time(0) ? 0 : static_cast<std::size_t>(room / hokuyo.period()) + 1;
}

}  // namespace

struct Tour::State {
  State(const World& world_, const Route& route_, const TourConfig& config)
      : world(world_),
        route(route_),
        tilt(config.tilt),
        hokuyo(config.hokuyo, stream_seed(config.seed, kRangeStream)),
        base_hokuyo(config.base_hokuyo, stream_seed(config.seed, kBaseRangeStream)),
        localisation(route, config.localisation, stream_seed(config.seed, kLocalisationStream)) {
    require_free(world, route);
    view = route_view(world, route, tilt, config.hokuyo);
    T_map_odom_at_start =
        route.T_map_base(Time(0)) * localisation.T_odom_base(Time(0)).inverse(Eigen::Isometry);
  }

  Pose T_map_laser(Time time) const {
    return pr2::T_map_laser(route.T_map_base(time), tilt.angle_rad(time));
  }

  const World& world;
  Route route;
  TiltProfile tilt;
  Hokuyo hokuyo, base_hokuyo;
  Localisation localisation;
  std::string view;
  Pose T_map_odom_at_start = Pose::Identity();
  std::size_t next_line = 0;
};

Tour::Tour(const World& world, const Route& route, const TourConfig& config)
    : state_(std::make_unique<State>(world, route, config)) {}

Tour::~Tour() = default;

const std::string& Tour::view() const { return state_->view; }

Time Tour::duration() const { return state_->route.duration(); }

std::size_t Tour::line_count() const { return lines_within(duration(), state_->hokuyo); }

std::size_t Tour::base_line_count() const { return lines_within(duration(), state_->base_hokuyo); }

std::optional<Scan> Tour::next_scan() {
  if (state_->next_line >= line_count()) return std::nullopt;
  return scan(state_->next_line++);
}

Scan Tour::scan(std::size_t line) const {
  Scan scan = state_->hokuyo.scan(state_->world, stamp_of_line(line, state_->hokuyo),
                                  [this](Time time) { return state_->T_map_laser(time); });
  scan.ground_m = true_T_map_base(scan.stamp).translation().z();
  return scan;
}

Scan Tour::base_scan(std::size_t line) const {
  const Pose T_base_laser = pr2::T_base_base_laser();
  return state_->base_hokuyo.scan(
      state_->world, stamp_of_line(line, state_->base_hokuyo),
      [&](Time time) { return state_->route.T_map_base(time) * T_base_laser; });
}

Time Tour::base_scan_stamp(std::size_t line) const {
  return stamp_of_line(line, state_->base_hokuyo);
}

Time Tour::base_scan_end(std::size_t line) const {
  return base_scan_stamp(line) + state_->base_hokuyo.sweep_time();
}

Pose Tour::true_T_map_base(Time time) const { return state_->route.T_map_base(time); }
Velocity Tour::true_velocity(Time time) const { return state_->route.velocity(time); }
Pose Tour::T_odom_base(Time time) const { return state_->localisation.T_odom_base(time); }
Pose Tour::T_map_odom_at_start() const { return state_->T_map_odom_at_start; }
Pose Tour::T_map_odom(Time time) const { return state_->localisation.T_map_odom(time); }
Pose Tour::noisy_T_map_base(Time time) const { return T_map_odom(time) * T_odom_base(time); }
double Tour::tilt_angle(Time time) const { return state_->tilt.angle_rad(time); }
Pose Tour::T_base_laser(Time time) const { return pr2::T_base_laser(tilt_angle(time)); }

}  // namespace ribbon_mapper::sim
