// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/truth/truth_patches.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace ribbon_mapper::sim {
namespace {

using Place = std::pair<std::int32_t, std::int32_t>;

std::uint64_t key_of(std::int32_t u, std::int32_t v) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(u)) << 32) |
         static_cast<std::uint32_t>(v);
}

/// Disjoint sets of cells (union-find with path halving).
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(int a, int b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

/// Returns the squared gap between the edges of two cells, in cells.
double squared_gap(const HitCell& a, const HitCell& b) {
  const double du = std::max(0, std::abs(a.u - b.u) - 1), dv = std::max(0, std::abs(a.v - b.v) - 1);
  return du * du + dv * dv;
}

/// Unites touching cells. Returns the cells on the rim, which alone can be near another patch.
std::vector<int> unite_touching(const std::vector<HitCell>& cells, Sets& sets) {
  std::unordered_map<std::uint64_t, int> at;
  for (std::size_t i = 0; i < cells.size(); ++i)
    at.emplace(key_of(cells[i].u, cells[i].v), static_cast<int>(i));
  std::vector<int> rim;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    int neighbours = 0;
    for (int du = -1; du <= 1; ++du)
      for (int dv = -1; dv <= 1; ++dv) {
        const auto found = at.find(key_of(cells[i].u + du, cells[i].v + dv));
        if (found == at.end()) continue;
        sets.unite(static_cast<int>(i), found->second);
        ++neighbours;
      }
    if (neighbours < 9) rim.push_back(static_cast<int>(i));
  }
  return rim;
}

/// Unites patches across gaps. Rim cells are sorted into squares as wide as the largest gap.
void unite_across_gaps(const std::vector<HitCell>& cells, const std::vector<int>& rim,
                       double max_gap_cells, Sets& sets) {
  const int width = static_cast<int>(std::ceil(max_gap_cells)) + 1;
  const auto square = [&](int i) {
    return Place{static_cast<std::int32_t>(std::floor(double(cells[i].u) / width)),
                 static_cast<std::int32_t>(std::floor(double(cells[i].v) / width))};
  };
  std::map<Place, std::vector<int>> squares;
  for (const int i : rim) squares[square(i)].push_back(i);
  for (const int i : rim)
    for (int du = -1; du <= 1; ++du)
      for (int dv = -1; dv <= 1; ++dv) {
        const auto found = squares.find({square(i).first + du, square(i).second + dv});
        if (found == squares.end()) continue;
        for (const int j : found->second)
          if (j > i && squared_gap(cells[i], cells[j]) <= max_gap_cells * max_gap_cells + 1e-9)
            sets.unite(i, j);
      }
}

struct Middle {
  double u, v;
};

Middle middle_of(const std::vector<HitCell>& patch) {
  Middle sum{0.0, 0.0};
  for (const HitCell& cell : patch) sum.u += cell.u, sum.v += cell.v;
  const auto count = static_cast<double>(patch.size());
  return {sum.u / count, sum.v / count};
}

}  // namespace

std::vector<std::vector<HitCell>> divided(const std::vector<HitCell>& patch, double max_gap_cells,
                                          double min_cells) {
  std::vector<std::vector<HitCell>> large, small;
  for (auto& part : linked_patches(patch, max_gap_cells)) {
    (static_cast<double>(part.size()) >= min_cells ? large : small).push_back(std::move(part));
  }
  if (large.size() < 2) return {patch};
  std::vector<Middle> middles;
  for (const auto& part : large) middles.push_back(middle_of(part));
  for (const auto& part : small) {
    const Middle own = middle_of(part);
    const auto distance = [&](const Middle& m) { return std::hypot(m.u - own.u, m.v - own.v); };
    const auto nearest = std::min_element(
        middles.begin(), middles.end(),
        [&](const Middle& a, const Middle& b) { return distance(a) < distance(b); });
    auto& into = large[static_cast<std::size_t>(nearest - middles.begin())];
    into.insert(into.end(), part.begin(), part.end());
  }
  return large;
}

std::vector<std::vector<HitCell>> linked_patches(std::vector<HitCell> cells, double max_gap_cells) {
  std::sort(cells.begin(), cells.end(), [](const HitCell& a, const HitCell& b) {
    return std::make_pair(a.u, a.v) < std::make_pair(b.u, b.v);
  });
  Sets sets(cells.size());
  unite_across_gaps(cells, unite_touching(cells, sets), max_gap_cells, sets);
  std::map<int, std::vector<HitCell>> by_root;
  for (std::size_t i = 0; i < cells.size(); ++i)
    by_root[sets.root(static_cast<int>(i))].push_back(cells[i]);
  std::vector<std::vector<HitCell>> patches;
  for (auto& [root, patch] : by_root) patches.push_back(std::move(patch));
  return patches;
}

}  // namespace ribbon_mapper::sim
