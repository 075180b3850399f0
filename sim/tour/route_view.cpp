// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/tour/route_view.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>
#include <stdexcept>

#include "sim/robot/pr2.hpp"

namespace ribbon_mapper::sim {
namespace {

constexpr int kLines = 101, kBeamsOfALine = 16;

/// Faces that rays hit, and how many rays hit one.
struct View {
  std::set<int> faces;
  int returns = 0;
};

View view_of(const World& world, const Route& route, const TiltProfile& tilt,
             const HokuyoConfig& hokuyo) {
  View view;
  const double step_rad = (hokuyo.angle_max_rad - hokuyo.angle_min_rad) / (kBeamsOfALine - 1);
  for (int line = 0; line < kLines; ++line) {
    const Time time = from_seconds(to_seconds(route.duration()) * (line + 0.5) / kLines);
    const Pose T_map_laser = pr2::T_map_laser(route.T_map_base(time), tilt.angle_rad(time));
    for (int beam = 0; beam < kBeamsOfALine; ++beam) {
      const double angle_rad = hokuyo.angle_min_rad + beam * step_rad;
      const Eigen::Vector3d beam_laser(std::cos(angle_rad), std::sin(angle_rad), 0.0);
      const auto hit = world.cast(T_map_laser.translation(), T_map_laser.linear() * beam_laser,
                                  hokuyo.range_max_m);
      if (!hit) continue;
      ++view.returns;
      view.faces.insert(hit->face);
    }
  }
  return view;
}

std::string span(const Eigen::AlignedBox3d& extent) {
  if (extent.isEmpty()) return "planes only";
  std::ostringstream text;
  text << std::setprecision(4) << "x " << extent.min().x() << " to " << extent.max().x() << ", y "
       << extent.min().y() << " to " << extent.max().y() << " m";
  return text.str();
}

}  // namespace

std::string route_view(const World& world, const Route& route, const TiltProfile& tilt,
                       const HokuyoConfig& hokuyo) {
  const View view = view_of(world, route, tilt, hokuyo);
  const bool is_within = std::any_of(view.faces.begin(), view.faces.end(), [&](int face) {
    return world.faces()[face].bounded || world.extent_m().isEmpty();
  });
  if (!is_within)
    throw std::runtime_error("the route lies outside of the world (" + span(world.extent_m()) +
                             "): along it, the laser sees " +
                             (view.returns == 0 ? "nothing" : "nothing but unbounded ground") +
                             "; move its waypoints [m, map]");
  std::ostringstream text;
  text << "the route of " << std::setprecision(4) << route.length_m() << " m sees "
       << view.faces.size() << " of " << world.faces().size() << " faces, "
       << std::lround(100.0 * view.returns / (kLines * kBeamsOfALine)) << " % of its rays return";
  return text.str();
}

}  // namespace ribbon_mapper::sim
