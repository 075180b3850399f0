// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/box_index.hpp"

#include <gtest/gtest.h>

#include <random>

namespace ribbon_mapper {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

/// Returns boxes of up to 2 m at random places within 10 m. One in ten is a point.
std::vector<AlignedBox3d> random_boxes(std::size_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place_m(0.0, 10.0), size_m(0.0, 2.0);
  std::vector<AlignedBox3d> boxes;
  while (boxes.size() < count) {
    const Vector3d corner(place_m(random), place_m(random), place_m(random));
    const Vector3d size(size_m(random), size_m(random), size_m(random));
    boxes.emplace_back(corner, boxes.size() % 10 == 0 ? corner : Vector3d(corner + size));
  }
  return boxes;
}

TEST(BoxIndex, FindsWhatASlowSearchFinds) {
  for (const std::size_t count : {1, 2, 3, 10, 300}) {
    const std::vector<AlignedBox3d> boxes = random_boxes(count);
    const BoxIndex index(boxes);
    for (const AlignedBox3d& box : boxes) {
      std::vector<std::size_t> expected;
      const Vector3d reach = Vector3d::Constant(0.5);
      const AlignedBox3d grown(box.min() - reach, box.max() + reach);
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (grown.intersects(boxes[i])) expected.push_back(i);
      }
      EXPECT_EQ(expected, index.near(box, 0.5));
    }
  }
}

TEST(BoxIndex, LeavesOutEmptyBoxes) {
  const AlignedBox3d box(Vector3d::Zero(), Vector3d::Ones());
  const BoxIndex index({AlignedBox3d(), box, AlignedBox3d()});
  EXPECT_EQ(std::vector<std::size_t>{1}, index.near(box, 1e9));
  EXPECT_TRUE(index.near(AlignedBox3d(), 1e9).empty());
  EXPECT_TRUE(BoxIndex({}).near(box, 1e9).empty());
}

}  // namespace
}  // namespace ribbon_mapper
