// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// A corner of the grid.
struct GridCorner {
  std::int32_t u = 0;  ///< column of the cell of which this is the lower left corner
  std::int32_t v = 0;  ///< row of that cell
};

/// A bitmap of the seen cells of a plane with a margin around them, 64 cells to a word.
class CellBitmap {
 public:
  /// Creates a bitmap of at least one cell, with a margin of this many cells on each side.
  CellBitmap(const std::vector<PlaneCell>& cells, int margin);

  /// Closes gaps of up to twice the margin, such as the stripes between scan lines: dilates by a
  /// square that reaches as far as the margin, then erodes by it.
  void close();

  /// Returns rectangles that cover each seen cell once: the runs of each row, with equal runs of
  /// successive rows united.
  std::vector<CellRectangle> rectangles() const;

  /// Fills a cell wherever two seen cells touch at a corner only, so that boundaries do not touch.
  void join_corners();

  /// Returns the boundaries of the seen area and of its holes, with seen cells to their left.
  std::vector<std::vector<GridCorner>> boundaries() const;

 private:
  using Words = std::vector<std::uint64_t>;

  std::size_t index(int u, int v) const { return static_cast<std::size_t>(v) * columns_ + u; }
  bool seen(int u, int v) const {
    if (u < 0 || v < 0 || u >= columns_ || v >= rows_) return false;
    return (seen_[index(u, v) / 64] >> (index(u, v) % 64)) & 1;
  }
  template <typename Join>
  void join_neighbours(const Join& join);
  std::vector<GridCorner> follow(int u, int v, Words& lower_edges) const;

  int margin_, u0_, v0_;
  // The last column stays empty, so that cells combined beyond the end of a row are unseen.
  int columns_, rows_;
  Words seen_;  // row after row
};

}  // namespace ribbon_mapper
