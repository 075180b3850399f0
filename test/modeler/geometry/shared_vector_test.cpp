// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/geometry/shared_vector.hpp"

#include <gtest/gtest.h>

#include <random>

namespace ribbon_mapper {
namespace {

std::vector<int> elements_of(const SharedVector<int>& shared) {
  std::vector<int> elements;
  for (std::size_t i = 0; i < shared.size(); ++i) elements.push_back(shared[i]);
  return elements;
}

std::size_t unshared(const SharedVector<int>& shared, const SharedVector<int>& other) {
  std::size_t count = 0;
  shared.for_each_unshared(other, [&count](int) { ++count; });
  return count;
}

TEST(SharedVector, CopiesAreIndependent) {
  std::mt19937 random(1);
  SharedVector<int> now;
  std::vector<int> expected;
  std::vector<SharedVector<int>> copies;
  std::vector<std::vector<int>> expected_copies;
  for (int i = 0; i < 1000; ++i) {
    const unsigned draw = random();
    if (expected.empty() || draw % 3 == 0) {
      now.push_back(i), expected.push_back(i);
    } else {
      now.edit(draw % expected.size()) = i, expected[draw % expected.size()] = i;
    }
    if (draw % 50 == 1) copies.push_back(now), expected_copies.push_back(expected);
    if (draw % 200 == 2) now = copies.at(0), expected = expected_copies.at(0);
  }
  EXPECT_EQ(expected, elements_of(now));
  ASSERT_GT(copies.size(), 5u);
  for (std::size_t i = 0; i < copies.size(); ++i) {
    EXPECT_EQ(expected_copies[i], elements_of(copies[i]));
  }
}

TEST(SharedVector, OnlyChangedBlocksTakeMemory) {
  SharedVector<int> now;
  for (int i = 0; i < 100; ++i) now.push_back(i);
  const SharedVector<int> before = now;
  EXPECT_EQ(0u, unshared(before, now));
  now.edit(50) = 0, now.edit(51) = 0;
  EXPECT_EQ(4u, unshared(before, now));
  EXPECT_EQ(100u, unshared(before, {}));
  const int* const changed = &now.edit(50);
  EXPECT_EQ(changed, &now.edit(50)) << "what is not shared is changed in place";
}

}  // namespace
}  // namespace ribbon_mapper
