// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include <tsl/robin_map.h>

#include "modeler/map/cell_grid.hpp"
#include "modeler/map/key_hash.hpp"

namespace ribbon_mapper {
namespace {

/// Cells fall into blocks so small that all in a block are connected; blocks are then joined where
/// two of their cells are near enough.
class Linkage {
 public:
  Linkage(const std::vector<PlaneCell>& cells, double gap_in_cells)
      : cells_(cells), gap_square_(gap_in_cells * gap_in_cells) {
    side_ = std::max(1, static_cast<int>(gap_in_cells / M_SQRT2) + 1);
    if (std::hypot(side_ - 1, side_ - 1) > gap_in_cells) --side_;
    reach_ = static_cast<int>(std::ceil(gap_in_cells / side_));
    sort_into_blocks();
    for (std::uint32_t block = 0; block < places_.size(); ++block) join_neighbours(block);
  }

  /// Of each cell, the first block of its component.
  std::vector<std::uint32_t> roots() {
    std::vector<std::uint32_t> roots(cells_.size());
    for (std::size_t i = 0; i < roots.size(); ++i) roots[i] = root_of(block_of_[i]);
    return roots;
  }

 private:
  struct Place {
    std::int32_t u, v;
  };

  static int floor_div(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

  /// Blocks are numbered by their first cells.
  void sort_into_blocks() {
    for (const PlaneCell& cell : cells_) {
      const Place place{floor_div(cell.u, side_), floor_div(cell.v, side_)};
      const bool is_last = !block_of_.empty() && places_[block_of_.back()].u == place.u &&
                           places_[block_of_.back()].v == place.v;
      if (is_last) {
        block_of_.push_back(block_of_.back());
        continue;
      }
      const auto number = static_cast<std::uint32_t>(places_.size());
      const auto [found, is_new] = blocks_.try_emplace(pair_key(place.u, place.v), number);
      if (is_new) places_.push_back(place);
      block_of_.push_back(found->second);
    }
    first_member_.assign(places_.size() + 1, 0);
    for (const std::uint32_t block : block_of_) ++first_member_[block + 1];
    std::partial_sum(first_member_.begin(), first_member_.end(), first_member_.begin());
    members_.resize(cells_.size());
    std::vector<std::uint32_t> next(first_member_.begin(), first_member_.end() - 1);
    for (std::uint32_t i = 0; i < cells_.size(); ++i) members_[next[block_of_[i]]++] = i;
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
    for (std::uint32_t i = first_member_[a]; i < first_member_[a + 1]; ++i) {
      for (std::uint32_t j = first_member_[b]; j < first_member_[b + 1]; ++j) {
        const PlaneCell &p = cells_[members_[i]], &q = cells_[members_[j]];
        const double du = p.u - q.u, dv = p.v - q.v;
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

  const std::vector<PlaneCell>& cells_;
  double gap_square_;
  int side_, reach_;
  tsl::robin_map<std::uint64_t, std::uint32_t, KeyHash> blocks_;
  std::vector<Place> places_;                          // of each block
  std::vector<std::uint32_t> block_of_;                // of each cell
  std::vector<std::uint32_t> first_member_, members_;  // of each block; cells
  std::vector<std::uint32_t> parent_;                  // of each block
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
