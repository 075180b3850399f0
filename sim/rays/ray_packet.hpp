// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "sim/rays/ray_caster.hpp"
#include "sim/rays/ray_scene.hpp"

namespace ribbon_mapper::sim {

/// Some rays, coordinate by coordinate in groups of four, so that one instruction works on several;
/// and bounds of all of them, which tell of four boxes at a time whether any ray may meet them.
class RayPacket {
 public:
  static constexpr int kMaxRays = 16;

  /// Of `count` rays, 1 to kMaxRays.
  RayPacket(const Ray* rays, int count, double max_range_m);

  /// Finds the first facet along each ray.
  void walk(const RayScene& scene);

  double range_m(int ray) const { return range_m_[ray / kWidth][ray % kWidth]; }
  /// Id of the facet met, -1 for none.
  int id(int ray) const { return static_cast<int>(id_[ray / kWidth][ray % kWidth]); }

 private:
  static constexpr int kWidth = 4, kMaxGroups = kMaxRays / kWidth;
  using Lanes = double __attribute__((vector_size(kWidth * sizeof(double))));
  using Mask = std::int64_t __attribute__((vector_size(kWidth * sizeof(std::int64_t))));

  /// Bounds along one axis, mirrored if the rays go down it: then all of them go up.
  struct Axis {
    float origin_low_m, origin_high_m;
    float direction_low, direction_high;
    float inverse_low, inverse_high;  ///< of the directions, unless they go both ways
    bool mirrored, both_ways;
  };
  static Axis bounds(const Ray* rays, int count, int axis);
  void meet(const RayScene::Item& item);
  BoxTree::Floats entries_m(const BoxTree::Node& node) const;

  int groups_;
  std::array<std::array<Lanes, kMaxGroups>, 3> origin_, direction_;
  std::array<Lanes, kMaxGroups> range_m_;
  std::array<Lanes, kMaxGroups> id_;  ///< in double: older processors compare these only
  std::array<Axis, 3> axes_;
  float reach_m_;  ///< no ray looks further than this
};

}  // namespace ribbon_mapper::sim
