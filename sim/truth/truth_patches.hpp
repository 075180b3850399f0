// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace ribbon_mapper::sim {

/// A cell of a plane's grid that a beam hit.
struct HitCell {
  std::int32_t u = 0;  ///< column
  std::int32_t v = 0;  ///< row
  int face = 0;        ///< index into World::faces()
  int number = 0;      ///< unique among all cells of a TruthCollector
};

/// Groups cells into patches by single linkage: cells whose edges are at most `max_gap_cells` apart
/// belong together. Neither the patches nor the cells in them depend on the order of `cells`.
std::vector<std::vector<HitCell>> linked_patches(std::vector<HitCell> cells, double max_gap_cells);

/// Divides a patch at gaps wider than `max_gap_cells` if at least two of the parts have
/// `min_cells`. Smaller parts stay with the large one whose middle is nearest.
std::vector<std::vector<HitCell>> divided(const std::vector<HitCell>& patch, double max_gap_cells,
                                          double min_cells);

}  // namespace ribbon_mapper::sim
