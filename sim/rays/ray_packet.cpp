// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/rays/ray_packet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

// The same code for processors with and without AVX2, chosen as the program starts. Neither of them
// contracts products and sums, so that the bytes are the same.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define RIBBON_MAPPER_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define RIBBON_MAPPER_WIDE
#endif
#define RIBBON_MAPPER_INLINE inline __attribute__((always_inline))

namespace ribbon_mapper::sim {
namespace {

using Floats = BoxTree::Floats;

/// Barycentric slack: no ray slips through the common edge of two facets.
constexpr double kEdgeSlack = 1e-9;

/// Bounds are kept in float: widened by more than its rounding.
constexpr float kShare = 1e-5F;
constexpr float kMargin_m = 1e-4F;
constexpr float kSlope = 1e-6F;

/// Slower along an axis than this, in metres per metre, counts as both ways.
constexpr float kLevel = 1e-4F;

constexpr float kNever_m = std::numeric_limits<float>::infinity();

}  // namespace

RayPacket::RayPacket(const Ray* rays, int count, double max_range_m)
    : groups_((count + kWidth - 1) / kWidth),
      reach_m_(static_cast<float>(max_range_m) * (1.0F + kShare) + kMargin_m) {
  for (int i = 0; i < groups_ * kWidth; ++i) {
    const Ray& ray = rays[std::min(i, count - 1)];
    for (int axis = 0; axis < 3; ++axis) {
      origin_[axis][i / kWidth][i % kWidth] = ray.origin[axis];
      direction_[axis][i / kWidth][i % kWidth] = ray.direction[axis];
    }
    range_m_[i / kWidth][i % kWidth] = max_range_m;
    id_[i / kWidth][i % kWidth] = -1;
  }
  for (int axis = 0; axis < 3; ++axis) axes_[axis] = bounds(rays, count, axis);
}

RayPacket::Axis RayPacket::bounds(const Ray* rays, int count, int axis) {
  double origin_low_m = rays[0].origin[axis], origin_high_m = origin_low_m;
  double low = rays[0].direction[axis], high = low;
  for (int i = 1; i < count; ++i) {
    origin_low_m = std::min(origin_low_m, rays[i].origin[axis]);
    origin_high_m = std::max(origin_high_m, rays[i].origin[axis]);
    low = std::min(low, rays[i].direction[axis]);
    high = std::max(high, rays[i].direction[axis]);
  }
  Axis result;
  result.mirrored = high < 0.0;
  if (result.mirrored) {
    std::tie(low, high) = std::make_pair(-high, -low);
    std::tie(origin_low_m, origin_high_m) = std::make_pair(-origin_high_m, -origin_low_m);
  }
  result.origin_low_m = static_cast<float>(origin_low_m) - kMargin_m;
  result.origin_high_m = static_cast<float>(origin_high_m) + kMargin_m;
  result.direction_low = static_cast<float>(low) - kSlope;
  result.direction_high = static_cast<float>(high) + kSlope;
  result.both_ways = result.direction_low < kLevel;
  result.inverse_low = (1.0F - kShare) / result.direction_high;
  result.inverse_high = (1.0F + kShare) / result.direction_low;
  return result;
}

/// Takes a facet over where it is nearer than what was met before.
RIBBON_MAPPER_INLINE void RayPacket::meet(const RayScene::Item& item) {
  const Facet& facet = item.facet;
  const auto &n = facet.plane.n, &nu = facet.u.n, &nv = facet.v.n;
  const Lanes zero{}, low = zero - kEdgeSlack, high = zero + (1.0 + kEdgeSlack);
  const Lanes most = zero + (facet.max_uv + kEdgeSlack);
  const Lanes own = zero + static_cast<double>(item.id);
  Mask any{};
  for (int g = 0; g < groups_; ++g) {
    const Lanes ox = origin_[0][g], oy = origin_[1][g], oz = origin_[2][g];
    const Lanes dx = direction_[0][g], dy = direction_[1][g], dz = direction_[2][g];
    const Lanes range_m =
        -(n[0] * ox + n[1] * oy + n[2] * oz + facet.plane.d) / (n[0] * dx + n[1] * dy + n[2] * dz);
    const Lanes px = ox + range_m * dx, py = oy + range_m * dy, pz = oz + range_m * dz;
    const Lanes u = nu[0] * px + nu[1] * py + nu[2] * pz + facet.u.d;
    const Lanes v = nv[0] * px + nv[1] * py + nv[2] * pz + facet.v.d;
    const Mask nearer = (range_m < range_m_[g]) | ((range_m == range_m_[g]) & (own < id_[g]));
    const Mask met = nearer & (range_m > zero) & (u >= low) & (v >= low) & (u <= high) &
                     (v <= high) & (u + v <= most);
    range_m_[g] = met ? range_m : range_m_[g];
    id_[g] = met ? own : id_[g];
    any |= met;
  }
  if ((any[0] | any[1] | any[2] | any[3]) == 0) return;
  Lanes furthest_m = range_m_[0];
  for (int g = 1; g < groups_; ++g)
    furthest_m = range_m_[g] > furthest_m ? range_m_[g] : furthest_m;
  const double reach_m =
      std::max(std::max(furthest_m[0], furthest_m[1]), std::max(furthest_m[2], furthest_m[3]));
  reach_m_ = static_cast<float>(reach_m) * (1.0F + kShare) + kMargin_m;
}

/// For each child of the node a range that no ray meets its box before, kNever_m if none meets it
/// within its reach.
RIBBON_MAPPER_INLINE Floats RayPacket::entries_m(const BoxTree::Node& node) const {
  Floats entry_m{}, exit_m = entry_m + reach_m_;
  for (int axis = 0; axis < 3; ++axis) {
    const Axis& bound = axes_[axis];
    const Floats near_m = bound.mirrored ? -node.high_m[axis] : node.low_m[axis];
    const Floats far_m = bound.mirrored ? -node.low_m[axis] : node.high_m[axis];
    if (bound.both_ways) {
      const float low_m = bound.origin_low_m + std::min(0.0F, bound.direction_low) * reach_m_;
      const float high_m = bound.origin_high_m + bound.direction_high * reach_m_;
      exit_m = (near_m > high_m) | (far_m < low_m) ? Floats{} - 1.0F : exit_m;
      continue;
    }
    const Floats in_m = (near_m - bound.origin_high_m) * bound.inverse_low;
    const Floats out_m = (far_m - bound.origin_low_m) * bound.inverse_high;
    entry_m = in_m > entry_m ? in_m : entry_m;
    exit_m = out_m < exit_m ? out_m : exit_m;
  }
  return entry_m <= exit_m ? entry_m : Floats{} + kNever_m;
}

/// Nearer boxes first, so that what was met rules out most of the others.
RIBBON_MAPPER_WIDE void RayPacket::walk(const RayScene& scene) {
  struct Place {
    float entry_m;
    std::int32_t first, count;
  };
  std::array<Place, BoxTree::kMaxLevels*(BoxTree::kChildren - 1) + 1> open;
  std::size_t size = 0;
  open[size++] = {0.0F, 0, 0};
  while (size > 0) {
    const Place place = open[--size];
    if (place.entry_m > reach_m_) continue;
    for (int i = 0; i < place.count; ++i) meet(scene.items[place.first + i]);
    if (place.count > 0) continue;
    const BoxTree::Node& node = scene.tree.nodes[place.first];
    const Floats entry_m = entries_m(node);
    const std::size_t bottom = size;
    for (int i = 0; i < BoxTree::kChildren; ++i) {
      if (entry_m[i] == kNever_m) continue;
      std::size_t at = size++;
      for (; at > bottom && open[at - 1].entry_m < entry_m[i]; --at) open[at] = open[at - 1];
      open[at] = {entry_m[i], node.first[i], node.count[i]};
    }
  }
}

}  // namespace ribbon_mapper::sim
