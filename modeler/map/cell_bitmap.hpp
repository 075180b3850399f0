// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/map/plane.hpp"

namespace ribbon_mapper {

/// A corner of the grid: the lower left one of cell (u, v).
struct GridCorner {
  std::int32_t u = 0, v = 0;
};

/// The seen cells of a plane as a picture with a margin around it. There must be cells.
class CellBitmap {
 public:
  CellBitmap(const std::vector<PlaneCell>& cells, int margin);

  /// Dilates, then erodes by a square of the margin: stripes between scan lines are closed.
  void close();

  /// Runs of each row; runs alike in successive rows become one rectangle.
  std::vector<CellRectangle> rectangles() const;

  /// The boundary around the largest area, counter-clockwise, corners only.
  std::vector<GridCorner> outer_boundary() const;

 private:
  bool seen(int u, int v) const {
    return u >= 0 && v >= 0 && u < columns_ && v < rows_ &&
           seen_[static_cast<std::size_t>(v) * columns_ + u];
  }
  void spread(char value, std::size_t step, int length, int lines);
  std::vector<GridCorner> follow(int u, int v, std::vector<char>& visited) const;

  int margin_, u0_, v0_, columns_, rows_;
  std::vector<char> seen_;
};

}  // namespace ribbon_mapper
