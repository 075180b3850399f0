// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/truth/hit_grid.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace ribbon_mapper::sim {
namespace {

TEST(HitGrid, KeepsTheFirstFaceAndNumberOfEachCell) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> near(-40, 40), far(-2000000, 2000000);
  HitGrid grid;
  std::map<std::pair<int, int>, int> expected;
  for (int face = 0; face < 5000; ++face) {
    auto& place = face % 10 == 0 ? far : near;
    const int u = place(random), v = place(random);
    const int number = grid.add(u, v, face, 10 * face);
    const auto first = expected.emplace(std::make_pair(u, v), face).first;
    EXPECT_EQ(number, 10 * first->second);
  }
  std::map<std::pair<int, int>, int> found;
  for (const HitCell& cell : grid.cells())
    EXPECT_TRUE(found.emplace(std::make_pair(cell.u, cell.v), cell.face).second);
  EXPECT_EQ(found, expected);
  EXPECT_LT(expected.size(), 5000U) << "some cells must be hit twice";
}

}  // namespace
}  // namespace ribbon_mapper::sim
