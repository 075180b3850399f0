// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "modeler/geometry/grid_keys.hpp"
#include "modeler/surface/cell_grid.hpp"

namespace ribbon_mapper {
namespace {

constexpr std::uint32_t kNone = UINT32_MAX;  // no block, no run

/// Single linkage of cells.
///
/// Cells are sorted into blocks that are so small that all cells of a block are connected. Blocks
/// with two cells near enough are joined (union-find). Within a block, adjacent cells of a row form
/// a run. Blocks are processed in bands of rows, and joined with those of the few earlier bands
/// within reach.
class Linkage {
 public:
  /// Links cells within `gap_in_cells` of each other. There must be cells, sorted by (v, u).
  Linkage(const std::vector<PlaneCell>& cells, double gap_in_cells)
      : gap_square_(gap_in_cells * gap_in_cells) {
    side_ = std::max(1, static_cast<int>(gap_in_cells / M_SQRT2) + 1);
    if (std::hypot(side_ - 1, side_ - 1) > gap_in_cells) --side_;
    reach_ = static_cast<int>(std::ceil(gap_in_cells / side_));
    make_bands(cells);
    find_runs(cells);
  }

  /// Returns the number of each cell's component; the largest component is number 0.
  std::vector<int> components(std::size_t cell_count) {
    std::vector<std::uint32_t> sizes(blocks_.size(), 0), order;  // of root blocks
    for (const Run& run : runs_) sizes[root_of(run.block)] += run.length;
    for (std::uint32_t block = 0; block < blocks_.size(); ++block) {
      if (sizes[block] > 0) order.push_back(block);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return sizes[a] > sizes[b]; });
    std::vector<int> numbers(blocks_.size(), 0), components;
    for (std::size_t i = 0; i < order.size(); ++i) numbers[order[i]] = static_cast<int>(i);
    components.reserve(cell_count);
    for (const Run& run : runs_) {
      components.insert(components.end(), run.length, numbers[root_of(run.block)]);
    }
    return components;
  }

 private:
  struct Run {
    std::int32_t u, v;
    std::uint32_t length, block;
    std::uint32_t previous;  // run of the same block, or kNone
  };
  struct Block {
    std::int32_t column;
    std::uint32_t last_run, parent;
  };

  int block_of(int cell) const { return floor_to_int((cell + 0.5) / side_); }

  /// Creates empty bands, as wide as the cells plus the reach on both sides.
  void make_bands(const std::vector<PlaneCell>& cells) {
    const auto [left, right] =
        std::minmax_element(cells.begin(), cells.end(),
                            [](const PlaneCell& a, const PlaneCell& b) { return a.u < b.u; });
    first_column_ = block_of(left->u) - reach_;
    const int columns = block_of(right->u) + reach_ + 1 - first_column_;
    bands_.assign(reach_ + 1, std::vector<std::uint32_t>(columns, kNone));
  }

  /// Divides the cells into runs and their blocks, and joins the blocks band by band.
  void find_runs(const std::vector<PlaneCell>& cells) {
    int band = block_of(cells.front().v);
    for (std::size_t i = 0; i < cells.size(); i += runs_.back().length) {
      const PlaneCell& first = cells[i];
      const int next_band = block_of(first.v), column = block_of(first.u);
      if (next_band != band) join_band(), move_on(next_band - band), band = next_band;
      const std::size_t end =
          std::min<std::size_t>(cells.size(), i + (column + 1) * side_ - first.u);
      Run run{first.u, first.v, 1, block_at(column), kNone};
      while (i + run.length < end && cells[i + run.length].v == run.v &&
             cells[i + run.length].u == run.u + static_cast<int>(run.length)) {
        ++run.length;
      }
      run.previous = blocks_[run.block].last_run;
      blocks_[run.block].last_run = static_cast<std::uint32_t>(runs_.size());
      runs_.push_back(run);
    }
    join_band();
  }

  /// Returns the block at a column of the latest band. Blocks are numbered by their first cells.
  std::uint32_t block_at(int column) {
    std::uint32_t& block = bands_.front()[column - first_column_];
    if (block == kNone) {
      block = static_cast<std::uint32_t>(blocks_.size());
      blocks_.push_back({column, kNone, block});
    }
    return block;
  }

  /// Moves on by a number of bands.
  void move_on(int bands) {
    for (int i = 0; i < std::min(bands, reach_ + 1); ++i) {
      std::rotate(bands_.begin(), bands_.end() - 1, bands_.end());
      std::fill(bands_.front().begin(), bands_.front().end(), kNone);
    }
    first_of_band_ = static_cast<std::uint32_t>(blocks_.size());
  }

  /// Joins the blocks of the latest band with all blocks before them within reach.
  void join_band() {
    for (std::uint32_t block = first_of_band_; block < blocks_.size(); ++block) {
      for (int dv = 0; dv <= reach_; ++dv) {
        const std::uint32_t* const middle = &bands_[dv][blocks_[block].column - first_column_];
        for (int du = -reach_; du <= (dv == 0 ? -1 : reach_); ++du) {
          if (middle[du] != kNone) join(block, middle[du]);
        }
      }
    }
  }

  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t root_a = root_of(a), root_b = root_of(b);
    if (root_a == root_b || !are_near(a, b)) return;
    blocks_[std::max(root_a, root_b)].parent = std::min(root_a, root_b);
  }

  /// Returns true if two cells of these blocks are within the gap.
  bool are_near(std::uint32_t a, std::uint32_t b) const {
    for (std::uint32_t i = blocks_[a].last_run; i != kNone; i = runs_[i].previous) {
      for (std::uint32_t j = blocks_[b].last_run; j != kNone; j = runs_[j].previous) {
        const Run &p = runs_[i], &q = runs_[j];
        const int p_last = p.u + static_cast<int>(p.length) - 1;
        const int q_last = q.u + static_cast<int>(q.length) - 1;
        const double du = std::max({0, q.u - p_last, p.u - q_last}), dv = p.v - q.v;
        if (du * du + dv * dv <= gap_square_) return true;
      }
    }
    return false;
  }

  std::uint32_t root_of(std::uint32_t block) {
    while (blocks_[block].parent != block) {
      block = blocks_[block].parent = blocks_[blocks_[block].parent].parent;
    }
    return block;
  }

  double gap_square_;
  int side_, reach_, first_column_ = 0;
  std::vector<Run> runs_;
  std::vector<Block> blocks_;
  std::uint32_t first_of_band_ = 0;                // first block of the latest band
  std::vector<std::vector<std::uint32_t>> bands_;  // blocks by column; the latest band first
};

}  // namespace

std::vector<int> connected_components(const std::vector<PlaneCell>& cells, double cell_size_m,
                                      double gap_m) {
  if (cells.empty()) return {};
  return Linkage(cells, gap_m / cell_size_m + 1e-6).components(cells.size());
}

}  // namespace ribbon_mapper
