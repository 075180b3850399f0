// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/truth/hit_grid.hpp"

namespace ribbon_mapper::sim {

void HitGrid::find(std::uint64_t key) {
  last_key_ = key;
  last_tile_ = &tiles_[key];
}

std::vector<HitCell> HitGrid::cells() const {
  std::vector<HitCell> cells;
  for (const auto& [key, tile] : tiles_) {
    const auto tile_u = static_cast<std::int32_t>(static_cast<std::uint32_t>(key >> 32));
    const auto tile_v = static_cast<std::int32_t>(static_cast<std::uint32_t>(key));
    for (std::int32_t v = 0; v < kTileSide; ++v)
      for (std::int32_t u = 0; u < kTileSide; ++u)
        if (const Hit& hit = tile[(v << kTileBits) | u]; hit.face >= 0)
          cells.push_back({tile_u * kTileSide + u, tile_v * kTileSide + v, hit.face, hit.number});
  }
  return cells;
}

}  // namespace ribbon_mapper::sim
