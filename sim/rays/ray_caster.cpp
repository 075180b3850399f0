// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/rays/ray_caster.hpp"

#include <algorithm>

#include "sim/rays/ray_packet.hpp"
#include "sim/rays/ray_scene.hpp"

namespace ribbon_mapper::sim {

RayCaster::RayCaster(const std::vector<Triangle>& triangles)
    : scene_(std::make_unique<RayScene>(triangles)) {}

RayCaster::~RayCaster() = default;

std::optional<Hit> RayCaster::cast(const Ray& ray, double max_range_m) const {
  RayPacket packet(&ray, 1, max_range_m);
  packet.walk(*scene_);
  if (packet.id(0) < 0) return std::nullopt;
  return Hit{packet.range_m(0), scene_->faces[packet.id(0)]};
}

std::vector<std::optional<Hit>> RayCaster::cast_line(const std::vector<Ray>& rays,
                                                     double max_range_m) const {
  std::vector<std::optional<Hit>> hits(rays.size());
  for (std::size_t begin = 0; begin < rays.size(); begin += RayPacket::kMaxRays) {
    const std::size_t left = rays.size() - begin;
    const int count = static_cast<int>(std::min<std::size_t>(left, RayPacket::kMaxRays));
    RayPacket packet(&rays[begin], count, max_range_m);
    packet.walk(*scene_);
    for (int i = 0; i < count; ++i)
      if (packet.id(i) >= 0) hits[begin + i] = Hit{packet.range_m(i), scene_->faces[packet.id(i)]};
  }
  return hits;
}

}  // namespace ribbon_mapper::sim
