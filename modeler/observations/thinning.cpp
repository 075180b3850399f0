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

constexpr double kVoxel_m = 0.25;  // five cells wide: holds a few lines of one tilt of the laser

/// Counts the ribbons that see each voxel from each of six sides.
class Density {
 public:
  explicit Density(const PosedObservations& observations) {
    for (std::uint32_t i = 0; i < observations.ribbon_count(); ++i) {
      first_.push_back(static_cast<std::uint32_t>(voxels_.size()));
      enter(observations.ribbon(i));
    }
    first_.push_back(static_cast<std::uint32_t>(voxels_.size()));
  }

  /// Returns the smallest number of ribbons in any voxel of a ribbon, this ribbon included.
  std::uint32_t min_density(std::uint32_t ribbon) const {
    std::uint32_t min_count = counts_[voxels_[first_[ribbon]]];
    for (std::uint32_t i = first_[ribbon]; i < first_[ribbon + 1]; ++i) {
      min_count = std::min(min_count, counts_[voxels_[i]]);
    }
    return min_count;
  }

  /// Removes a ribbon from the counts.
  void remove(std::uint32_t ribbon) {
    for (std::uint32_t i = first_[ribbon]; i < first_[ribbon + 1]; ++i) --counts_[voxels_[i]];
  }

 private:
  void enter(const PosedRibbon& ribbon) {
    const double length_m = ribbon.ribbon->length_m;
    const int steps = static_cast<int>(std::ceil(length_m / kVoxel_m));
    for (int i = 0; i <= steps; ++i) {
      const double along_m = ribbon.ribbon->samples.start_m + length_m * i / std::max(1, steps);
      const VoxelKey voxel = voxel_key(ribbon.centroid + along_m * ribbon.along, kVoxel_m);
      const std::uint64_t key = KeyHash()(voxel) ^ static_cast<VoxelKey>(cube_side(ribbon.normal));
      const auto number = static_cast<std::uint32_t>(counts_.size());
      const auto [entry, is_new] = numbers_.try_emplace(key, number);
      if (is_new) counts_.push_back(0);
      ++counts_[entry->second];
      voxels_.push_back(entry->second);
    }
  }

  tsl::robin_map<std::uint64_t, std::uint32_t> numbers_;  // of voxels and sides
  std::vector<std::uint32_t> counts_;                     // of ribbons, by number
  std::vector<std::uint32_t> first_, voxels_;             // numbers by ribbon: from first_[i] on
};

}  // namespace

std::vector<std::uint32_t> thinned(const PosedObservations& observations, std::size_t count) {
  const std::size_t all = observations.ribbon_count();
  std::vector<std::uint32_t> kept(all);
  std::iota(kept.begin(), kept.end(), 0u);
  if (all <= count) return kept;
  Density density(observations);
  // Density, tie breaker, ribbon. The tie breaker is a hash, so that among equally dense ribbons
  // neither position nor time decides.
  std::priority_queue<std::tuple<std::uint32_t, std::size_t, std::uint32_t>> densest;
  for (std::uint32_t i = 0; i < all; ++i) densest.emplace(density.min_density(i), KeyHash()(i), i);
  std::vector<bool> is_removed(all, false);
  for (std::size_t removed = 0; removed < all - count;) {
    const auto [former_density, tie_breaker, ribbon] = densest.top();
    densest.pop();
    const std::uint32_t now = density.min_density(ribbon);
    if (now < former_density) {  // others were removed meanwhile
      densest.emplace(now, tie_breaker, ribbon);
      continue;
    }
    density.remove(ribbon);
    is_removed[ribbon] = true;
    ++removed;
  }
  kept.erase(
      std::remove_if(kept.begin(), kept.end(), [&](std::uint32_t i) { return is_removed[i]; }),
      kept.end());
  return kept;
}

}  // namespace ribbon_mapper
