// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

#include "modeler/map/cell_grid.hpp"

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
    for (std::size_t i = 0; i < cells.size(); ++i) blocks_[block_of(cells[i])].push_back(i);
    parent_.resize(cells.size());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::vector<std::size_t> roots() {
    for (const auto& [block, members] : blocks_) {
      for (const std::size_t i : members) unite(members.front(), i);
    }
    for (const auto& [block, members] : blocks_) join_neighbours(block, members);
    std::vector<std::size_t> roots(cells_.size());
    for (std::size_t i = 0; i < roots.size(); ++i) roots[i] = root_of(i);
    return roots;
  }

 private:
  using Block = std::pair<int, int>;
  using Members = std::vector<std::size_t>;

  Block block_of(const PlaneCell& cell) const {
    return {static_cast<int>(std::floor(static_cast<double>(cell.v) / side_)),
            static_cast<int>(std::floor(static_cast<double>(cell.u) / side_))};
  }

  void join_neighbours(const Block& block, const Members& members) {
    for (int dv = 0; dv <= reach_; ++dv) {
      for (int du = dv == 0 ? 1 : -reach_; du <= reach_; ++du) {
        const auto other = blocks_.find({block.first + dv, block.second + du});
        if (other == blocks_.end()) continue;
        if (root_of(members.front()) == root_of(other->second.front())) continue;
        if (are_near(members, other->second)) unite(members.front(), other->second.front());
      }
    }
  }

  bool are_near(const Members& a, const Members& b) const {
    for (const std::size_t i : a) {
      for (const std::size_t j : b) {
        const double du = cells_[i].u - cells_[j].u, dv = cells_[i].v - cells_[j].v;
        if (du * du + dv * dv <= gap_square_) return true;
      }
    }
    return false;
  }

  std::size_t root_of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::size_t a, std::size_t b) {
    a = root_of(a), b = root_of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  const std::vector<PlaneCell>& cells_;
  double gap_square_;
  int side_, reach_;
  std::map<Block, Members> blocks_;
  std::vector<std::size_t> parent_;
};

}  // namespace

std::vector<int> connected_components(const std::vector<PlaneCell>& cells, double cell_size_m,
                                      double gap_m) {
  const std::vector<std::size_t> roots = Linkage(cells, gap_m / cell_size_m + 1e-6).roots();
  std::map<std::size_t, std::size_t> sizes;
  for (const std::size_t root : roots) ++sizes[root];
  std::vector<std::pair<std::size_t, std::size_t>> order(sizes.begin(), sizes.end());
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::map<std::size_t, int> numbers;
  for (std::size_t i = 0; i < order.size(); ++i) numbers[order[i].first] = static_cast<int>(i);
  std::vector<int> components;
  for (const std::size_t root : roots) components.push_back(numbers[root]);
  return components;
}

}  // namespace ribbon_mapper
