// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/metrics/outline_iou.hpp"

#include <gtest/gtest.h>

#include "modeler/surface/outline.hpp"

namespace ribbon_mapper::eval {
namespace {

/// Returns a level plane of 2 m x 1 m from x_m on, with a window of `window` x 10 cells.
Plane table(double x_m, int window = 0) {
  Plane plane;
  plane.origin.x() = x_m;
  for (int v = 0; v < 20; ++v) {
    for (int u = 0; u < 40; ++u) {
      const bool open = u >= 10 && u < 10 + window && v >= 5 && v < 15;
      if (!open) plane.cells.push_back({u, v, 1, 0.0F, 0.0F});
    }
  }
  plane.outlines = outlines_of(plane, {});
  return plane;
}

TEST(OutlineIou, OfTheSameAreaIsOne) {
  EXPECT_NEAR(outline_iou({table(3.0, 12)}, {table(3.0, 12)}, {{0, 0}}).value(), 1.0, 1e-9);
}

TEST(OutlineIou, ComparesAreasInOnePlane) {
  EXPECT_NEAR(outline_iou({table(0.5)}, {table(0.0)}, {{0, 0}}).value(), 1.5 / 2.5, 1e-9);
}

TEST(OutlineIou, CountsAWindowThatIsClosed) {
  const double window_m2 = 0.6 * 0.5;
  EXPECT_NEAR(outline_iou({table(0.0)}, {table(0.0, 12)}, {{0, 0}}).value(),
              (2.0 - window_m2) / 2.0, 1e-9);
}

TEST(OutlineIou, CountsMissedPlanesByTheirArea) {
  EXPECT_NEAR(outline_iou({table(0.0)}, {table(9.0), table(0.0)}, {{0, 1}}).value(), 0.5, 1e-9);
}

TEST(OutlineIou, NeedsTruthAndOutlines) {
  EXPECT_FALSE(outline_iou({table(0.0)}, {}, {}));
  Plane bare = table(0.0);
  bare.outlines.clear();
  EXPECT_FALSE(outline_iou({bare}, {table(0.0)}, {{0, 0}}));
}

}  // namespace
}  // namespace ribbon_mapper::eval
