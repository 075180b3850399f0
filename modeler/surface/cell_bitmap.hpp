// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// A corner of the grid: the lower left one of cell (u, v).
struct GridCorner {
  std::int32_t u = 0, v = 0;
};

/// The seen cells of a plane as a picture with a margin around it, 64 of them to a word. There must
/// be cells.
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
  using Words = std::vector<std::uint64_t>;

  std::size_t place(int u, int v) const { return static_cast<std::size_t>(v) * columns_ + u; }
  bool seen(int u, int v) const {
    if (u < 0 || v < 0 || u >= columns_ || v >= rows_) return false;
    return (seen_[place(u, v) / 64] >> (place(u, v) % 64)) & 1;
  }
  template <typename Join>
  void join_neighbours(const Join& join);
  std::vector<GridCorner> follow(int u, int v, Words& lower_edges) const;

  int margin_, u0_, v0_;
  /// The last column stays empty, so that what is joined beyond the end of a row is unseen, too.
  int columns_, rows_;
  Words seen_;  // row after row
};

}  // namespace ribbon_mapper
