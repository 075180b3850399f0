// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "sim/truth/truth_patches.hpp"

namespace ribbon_mapper::sim {

/// The cells of a plane's grid that beams hit, and the first face hit in each. Cells are stored in
/// square tiles, because successive beams mostly hit the same tile.
class HitGrid {
 public:
  /// Makes a grid without hits.
  HitGrid() = default;
  /// Takes over the cells of another grid.
  HitGrid(HitGrid&&) = default;
  HitGrid(const HitGrid&) = delete;  // it points into itself

  /// Adds a hit of `face` at column `u` and row `v`. Returns the number of the cell, which is
  /// `next_number` at its first hit.
  int add(std::int32_t u, std::int32_t v, int face, int next_number) {
    const std::uint64_t key = key_of(u >> kTileBits, v >> kTileBits);
    if (key != last_key_ || !last_tile_) find(key);
    Hit& hit = (*last_tile_)[((v & kMask) << kTileBits) | (u & kMask)];
    if (hit.face < 0) hit = {face, next_number};
    return hit.number;
  }

  /// Returns all cells with a hit, in no particular order.
  std::vector<HitCell> cells() const;

 private:
  static constexpr int kTileBits = 5, kTileSide = 1 << kTileBits, kMask = kTileSide - 1;
  struct Hit {
    std::int32_t face = -1;  ///< -1: not hit
    std::int32_t number = 0;
  };
  using Tile = std::array<Hit, kTileSide * kTileSide>;

  static std::uint64_t key_of(std::int32_t u, std::int32_t v) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(u)) << 32) |
           static_cast<std::uint32_t>(v);
  }
  void find(std::uint64_t key);

  std::unordered_map<std::uint64_t, Tile> tiles_;
  std::uint64_t last_key_ = 0;
  Tile* last_tile_ = nullptr;  ///< remains valid when tiles are added
};

}  // namespace ribbon_mapper::sim
