// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "modeler/association/plane_map.hpp"

namespace ribbon_mapper {

/// States of a plane map on the way to what it is now. From one of them, ribbons are associated
/// again without all those before.
///
/// The further back, the larger the gaps between them: half the number of ribbons since then. So
/// there are a few dozen at most, and a return to any ribbon repeats half as many ribbons again.
class Checkpoints {
 public:
  /// A map that had aggregated the first `ribbons` of its ribbons.
  struct Checkpoint {
    std::uint32_t ribbons;  ///< number of ribbons, whole lines
    PlaneMap::State state;  ///< the map
  };

  /// Creates an empty set. Between two checkpoints there are at least `min_ribbons`, and a 256th of
  /// all ribbons; none are kept if it is 0.
  explicit Checkpoints(int min_ribbons) : min_ribbons_(static_cast<std::uint32_t>(min_ribbons)) {}

  /// Keeps the state of a map with the first `ribbons` ribbons, of `all` that it will have soon, if
  /// the gap since the last checkpoint is wide enough. Removes those that have become too dense.
  void offer(const PlaneMap& map, std::uint32_t ribbons, std::uint32_t all);

  /// Returns the last checkpoint of at most so many ribbons, or null.
  const Checkpoint* last_until(std::uint32_t ribbons) const;

  /// Returns the checkpoints of at most so many ribbons.
  Checkpoints until(std::uint32_t ribbons) const;

  /// Returns the memory that the checkpoints do not share with the map. Visits every hypothesis.
  std::size_t memory_bytes(const PlaneMap& now) const;

 private:
  std::uint32_t gap(std::uint32_t ribbons, std::uint32_t all) const;

  std::uint32_t min_ribbons_;
  std::vector<std::shared_ptr<const Checkpoint>> checkpoints_;  // ascending
};

}  // namespace ribbon_mapper
