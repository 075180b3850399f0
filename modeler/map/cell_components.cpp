// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <tsl/robin_map.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "modeler/map/cell_grid.hpp"
#include "modeler/map/grid_keys.hpp"

namespace ribbon_mapper {
namespace {

int floor_div(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

/// Cells fall into blocks so small that all in a block are connected; blocks are then joined where
/// two of their cells are near enough. Within a block, cells that follow each other are one run.
class Linkage {
 public:
  Linkage(const std::vector<PlaneCell>& cells, double gap_in_cells)
      : gap_square_(gap_in_cells * gap_in_cells) {
    side_ = std::max(1, static_cast<int>(gap_in_cells / M_SQRT2) + 1);
    if (std::hypot(side_ - 1, side_ - 1) > gap_in_cells) --side_;
    reach_ = static_cast<int>(std::ceil(gap_in_cells / side_));
    find_runs(cells);
    sort_runs_by_block();
    for (std::uint32_t block = 0; block < places_.size(); ++block) join_neighbours(block);
  }

  /// Of each cell, the first block of its component.
  std::vector<std::uint32_t> roots() {
    std::vector<std::uint32_t> roots;
    for (const Run& run : runs_) roots.resize(run.end_cell, root_of(run.block));
    return roots;
  }

 private:
  struct Place {
    std::int32_t u, v;
  };
  struct Run {
    std::int32_t v, u_first, u_last;
    std::uint32_t end_cell, block;
  };

  /// Blocks are numbered by their first cells.
  void find_runs(const std::vector<PlaneCell>& cells) {
    for (std::uint32_t i = 0; i < cells.size();) {
      const PlaneCell& first = cells[i];
      const Place place{floor_div(first.u, side_), floor_div(first.v, side_)};
      const std::int32_t u_end = (place.u + 1) * side_;
      Run run{first.v, first.u, first.u, i + 1, 0};
      while (run.end_cell < cells.size() && cells[run.end_cell].v == run.v &&
             cells[run.end_cell].u == run.u_last + 1 && run.u_last + 1 < u_end) {
        ++run.u_last, ++run.end_cell;
      }
      const auto number = static_cast<std::uint32_t>(places_.size());
      const auto [found, is_new] = blocks_.try_emplace(pair_key(place.u, place.v), number);
      if (is_new) places_.push_back(place);
      run.block = found->second;
      runs_.push_back(run);
      i = run.end_cell;
    }
  }

  void sort_runs_by_block() {
    first_run_.assign(places_.size() + 1, 0);
    for (const Run& run : runs_) ++first_run_[run.block + 1];
    std::partial_sum(first_run_.begin(), first_run_.end(), first_run_.begin());
    runs_of_block_.resize(runs_.size());
    std::vector<std::uint32_t> next(first_run_.begin(), first_run_.end() - 1);
    for (std::uint32_t i = 0; i < runs_.size(); ++i) runs_of_block_[next[runs_[i].block]++] = i;
    parent_.resize(places_.size());
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  void join_neighbours(std::uint32_t block) {
    const Place place = places_[block];
    for (int dv = 0; dv <= reach_; ++dv) {
      for (int du = dv == 0 ? 1 : -reach_; du <= reach_; ++du) {
        const auto other = blocks_.find(pair_key(place.u + du, place.v + dv));
        if (other == blocks_.end() || root_of(block) == root_of(other->second)) continue;
        if (are_near(block, other->second)) unite(block, other->second);
      }
    }
  }

  bool are_near(std::uint32_t a, std::uint32_t b) const {
    for (std::uint32_t i = first_run_[a]; i < first_run_[a + 1]; ++i) {
      for (std::uint32_t j = first_run_[b]; j < first_run_[b + 1]; ++j) {
        const Run &p = runs_[runs_of_block_[i]], &q = runs_[runs_of_block_[j]];
        const double du = std::max({0, q.u_first - p.u_last, p.u_first - q.u_last});
        const double dv = p.v - q.v;
        if (du * du + dv * dv <= gap_square_) return true;
      }
    }
    return false;
  }

  std::uint32_t root_of(std::uint32_t block) {
    while (parent_[block] != block) block = parent_[block] = parent_[parent_[block]];
    return block;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = root_of(a), b = root_of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  double gap_square_;
  int side_, reach_;
  std::vector<Run> runs_;
  tsl::robin_map<std::uint64_t, std::uint32_t, KeyHash> blocks_;
  std::vector<Place> places_;                             // of each block
  std::vector<std::uint32_t> first_run_, runs_of_block_;  // of each block
  std::vector<std::uint32_t> parent_;                     // of each block
};

}  // namespace

std::vector<int> connected_components(const std::vector<PlaneCell>& cells, double cell_size_m,
                                      double gap_m) {
  const std::vector<std::uint32_t> roots = Linkage(cells, gap_m / cell_size_m + 1e-6).roots();
  std::vector<std::size_t> sizes(cells.size(), 0);
  for (const std::uint32_t root : roots) ++sizes[root];
  std::vector<std::uint32_t> order;
  for (std::uint32_t root = 0; root < sizes.size(); ++root) {
    if (sizes[root] > 0) order.push_back(root);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return sizes[a] > sizes[b]; });
  std::vector<int> numbers(cells.size(), 0), components;
  for (std::size_t i = 0; i < order.size(); ++i) numbers[order[i]] = static_cast<int>(i);
  components.reserve(roots.size());
  for (const std::uint32_t root : roots) components.push_back(numbers[root]);
  return components;
}

}  // namespace ribbon_mapper
