// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/truth/truth_patches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace ribbon_mapper::sim {
namespace {

using Places = std::set<std::pair<int, int>>;

std::set<Places> as_sets(const std::vector<std::vector<HitCell>>& patches) {
  std::set<Places> result;
  for (const auto& patch : patches) {
    Places places;
    for (const HitCell& cell : patch) places.emplace(cell.u, cell.v);
    result.insert(places);
  }
  return result;
}

/// Applies the definition: a patch grows from one cell by comparison with all others.
std::set<Places> slowly_linked(std::vector<HitCell> cells, double max_gap_cells) {
  std::set<Places> result;
  while (!cells.empty()) {
    std::vector<HitCell> open{cells.back()};
    cells.pop_back();
    Places patch;
    while (!open.empty()) {
      const HitCell a = open.back();
      open.pop_back();
      patch.emplace(a.u, a.v);
      const auto is_near = [&](const HitCell& b) {
        return std::hypot(std::max(0, std::abs(a.u - b.u) - 1),
                          std::max(0, std::abs(a.v - b.v) - 1)) <= max_gap_cells + 1e-9;
      };
      const auto far =
          std::partition(cells.begin(), cells.end(), [&](const HitCell& b) { return !is_near(b); });
      open.insert(open.end(), far, cells.end());
      cells.erase(far, cells.end());
    }
    result.insert(patch);
  }
  return result;
}

std::vector<HitCell> scattered(int count, int side, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> place(-side, side);
  std::set<std::pair<int, int>> places;
  while (static_cast<int>(places.size()) < count) places.emplace(place(random), place(random));
  std::vector<HitCell> cells;
  for (const auto& [u, v] : places) cells.push_back({u, v, 0});
  std::shuffle(cells.begin(), cells.end(), random);
  return cells;
}

TEST(TruthPatches, AgreesWithTheSlowDefinition) {
  bool several = false;
  for (const int side : {20, 60, 150})
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const std::vector<HitCell> cells = scattered(300, side, seed);
      for (const double gap : {0.0, 4.0, 20.0}) {
        const auto patches = as_sets(linked_patches(cells, gap));
        EXPECT_EQ(patches, slowly_linked(cells, gap)) << side << " " << gap;
        several |= patches.size() > 1 && patches.size() < 200;
      }
    }
  EXPECT_TRUE(several);
}

TEST(TruthPatches, OrderDoesNotMatter) {
  std::vector<HitCell> cells = scattered(300, 60, 9);
  const auto same = [](const std::vector<HitCell>& a, const std::vector<HitCell>& b) {
    return a.size() == b.size() &&
           std::equal(a.begin(), a.end(), b.begin(), [](const HitCell& x, const HitCell& y) {
             return x.u == y.u && x.v == y.v && x.face == y.face;
           });
  };
  const auto first = linked_patches(cells, 3.0);
  std::reverse(cells.begin(), cells.end());
  const auto second = linked_patches(cells, 3.0);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_TRUE(same(first[i], second[i]));
}

TEST(TruthPatches, OfNothing) { EXPECT_TRUE(linked_patches({}, 20.0).empty()); }

}  // namespace
}  // namespace ribbon_mapper::sim
