// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/observations/thinning.hpp"

#include <tsl/robin_map.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>

#include "modeler/geometry/cube_sides.hpp"
#include "modeler/geometry/voxel_key.hpp"

namespace ribbon_mapper {
namespace {

constexpr double place_m = 0.25;  // five cells: a few lines of one sweep

/// How many ribbons see each place from each of six sides.
class Density {
 public:
  explicit Density(const PosedObservations& observations) {
    for (std::uint32_t i = 0; i < observations.ribbon_count(); ++i) {
      first_.push_back(static_cast<std::uint32_t>(places_.size()));
      enter(observations.ribbon(i));
    }
    first_.push_back(static_cast<std::uint32_t>(places_.size()));
  }

  /// Of a ribbon's places, the number of ribbons in the least seen one.
  std::uint32_t least(std::uint32_t ribbon) const {
    std::uint32_t least = counts_[places_[first_[ribbon]]];
    for (std::uint32_t i = first_[ribbon]; i < first_[ribbon + 1]; ++i) {
      least = std::min(least, counts_[places_[i]]);
    }
    return least;
  }

  void leave_out(std::uint32_t ribbon) {
    for (std::uint32_t i = first_[ribbon]; i < first_[ribbon + 1]; ++i) --counts_[places_[i]];
  }

 private:
  void enter(const PosedRibbon& ribbon) {
    const double length_m = ribbon.ribbon->length_m;
    const int steps = static_cast<int>(std::ceil(length_m / place_m));
    for (int i = 0; i <= steps; ++i) {
      const double along_m = ribbon.ribbon->samples.start_m + length_m * i / std::max(1, steps);
      const VoxelKey voxel = voxel_key(ribbon.centroid + along_m * ribbon.along, place_m);
      const std::uint64_t key = KeyHash()(voxel) ^ static_cast<VoxelKey>(cube_side(ribbon.normal));
      const auto number = static_cast<std::uint32_t>(counts_.size());
      const auto [place, is_new] = numbers_.try_emplace(key, number);
      if (is_new) counts_.push_back(0);
      ++counts_[place->second];
      places_.push_back(place->second);
    }
  }

  tsl::robin_map<std::uint64_t, std::uint32_t> numbers_;  // of places
  std::vector<std::uint32_t> counts_;                     // of each place
  std::vector<std::uint32_t> first_, places_;             // of each ribbon
};

}  // namespace

std::vector<std::uint32_t> thinned(const PosedObservations& observations, std::size_t count) {
  const std::size_t all = observations.ribbon_count();
  std::vector<std::uint32_t> kept(all);
  std::iota(kept.begin(), kept.end(), 0u);
  if (all <= count) return kept;
  Density density(observations);
  // Density, lot, ribbon: of those that are equally dense, none is the first by its place or time.
  std::priority_queue<std::tuple<std::uint32_t, std::size_t, std::uint32_t>> densest;
  for (std::uint32_t i = 0; i < all; ++i) densest.emplace(density.least(i), KeyHash()(i), i);
  std::vector<bool> is_left_out(all, false);
  for (std::size_t left_out = 0; left_out < all - count;) {
    const auto [density_then, lot, ribbon] = densest.top();
    densest.pop();
    const std::uint32_t now = density.least(ribbon);
    if (now < density_then) {  // others have gone since
      densest.emplace(now, lot, ribbon);
      continue;
    }
    density.leave_out(ribbon);
    is_left_out[ribbon] = true;
    ++left_out;
  }
  kept.erase(
      std::remove_if(kept.begin(), kept.end(), [&](std::uint32_t i) { return is_left_out[i]; }),
      kept.end());
  return kept;
}

}  // namespace ribbon_mapper
