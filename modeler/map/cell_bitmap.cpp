// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/cell_bitmap.hpp"

#include <algorithm>

namespace ribbon_mapper {
namespace {

/// In cells, positive if counter-clockwise: the boundary of a hole is not.
double signed_area(const std::vector<GridCorner>& corners) {
  double twice = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const GridCorner& a = corners[i];
    const GridCorner& b = corners[(i + 1) % corners.size()];
    twice += static_cast<double>(a.u) * b.v - static_cast<double>(b.u) * a.v;
  }
  return 0.5 * twice;
}

}  // namespace

CellBitmap::CellBitmap(const std::vector<PlaneCell>& cells, int margin) : margin_(margin) {
  int u_max = cells.front().u, v_max = cells.front().v;
  u0_ = u_max, v0_ = v_max;
  for (const PlaneCell& cell : cells) {
    u0_ = std::min(u0_, cell.u), u_max = std::max(u_max, cell.u);
    v0_ = std::min(v0_, cell.v), v_max = std::max(v_max, cell.v);
  }
  u0_ -= margin, v0_ -= margin;
  columns_ = u_max - u0_ + margin + 1, rows_ = v_max - v0_ + margin + 1;
  seen_.assign(static_cast<std::size_t>(columns_) * rows_, 0);
  for (const PlaneCell& cell : cells) {
    seen_[static_cast<std::size_t>(cell.v - v0_) * columns_ + (cell.u - u0_)] = 1;
  }
}

void CellBitmap::close() {
  spread(1, 1, columns_, rows_), spread(1, columns_, rows_, columns_);
  spread(0, 1, columns_, rows_), spread(0, columns_, rows_, columns_);
}

/// Sets to `value` all within the margin of a cell of that value, along lines of `length` cells
/// that are `step` apart; beyond the picture nothing is seen.
void CellBitmap::spread(char value, std::size_t step, int length, int lines) {
  const std::size_t line_step = step == 1 ? columns_ : 1;
  std::vector<char> out(length);
  for (int k = 0; k < lines; ++k) {
    char* line = seen_.data() + k * line_step;
    std::fill(out.begin(), out.end(), 0);
    for (int pass = 0; pass < 2; ++pass) {
      int reach = value ? -1 : margin_;
      for (int i = 0; i < length; ++i) {
        const int at = pass ? length - 1 - i : i;
        if (line[at * step] == value) reach = margin_ + 1;
        if (--reach >= 0) out[at] = 1;
      }
    }
    for (int i = 0; i < length; ++i) {
      if (out[i]) line[i * step] = value;
    }
  }
}

std::vector<CellRectangle> CellBitmap::rectangles() const {
  std::vector<CellRectangle> done, open;
  for (int v = 0; v <= rows_; ++v) {
    std::vector<CellRectangle> now;
    for (int u = 0; u < columns_; ++u) {
      if (!seen(u, v)) continue;
      CellRectangle run{u + u0_, u + u0_, v + v0_, v + v0_ + 1};
      while (seen(u, v)) ++u;
      run.u_end = u + u0_;
      now.push_back(run);
    }
    for (const CellRectangle& old : open) {
      const auto same = std::find_if(now.begin(), now.end(), [&](const CellRectangle& run) {
        return run.u_begin == old.u_begin && run.u_end == old.u_end;
      });
      same == now.end() ? done.push_back(old) : void(same->v_begin = old.v_begin);
    }
    open = std::move(now);
  }
  return done;
}

std::vector<GridCorner> CellBitmap::outer_boundary() const {
  std::vector<char> visited(seen_.size(), 0);
  std::vector<GridCorner> largest;
  double largest_area = 0.0;
  for (int v = 0; v < rows_; ++v) {
    for (int u = 0; u < columns_; ++u) {
      if (!seen(u, v) || seen(u, v - 1) || visited[static_cast<std::size_t>(v) * columns_ + u]) {
        continue;
      }
      std::vector<GridCorner> boundary = follow(u, v, visited);
      const double area = signed_area(boundary);
      if (area > largest_area) largest = std::move(boundary), largest_area = area;
    }
  }
  return largest;
}

/// Walks along the edges with the seen cells to the left, from the lower edge of cell (u, v) on;
/// where two cells touch by a corner only, they are kept together.
std::vector<GridCorner> CellBitmap::follow(int u, int v, std::vector<char>& visited) const {
  constexpr int step_u[] = {1, 0, -1, 0}, step_v[] = {0, 1, 0, -1};
  constexpr int left_u[] = {0, -1, -1, 0}, left_v[] = {0, 0, -1, -1};  // cell left of a step
  const int start_u = u, start_v = v;
  int heading = 0;
  std::vector<GridCorner> corners;
  do {
    if (heading == 0) visited[static_cast<std::size_t>(v) * columns_ + u] = 1;
    u += step_u[heading], v += step_v[heading];
    for (const int turn : {3, 0, 1}) {  // right, straight, left
      const int next = (heading + turn) % 4;
      if (!seen(u + left_u[next], v + left_v[next])) continue;
      if (turn != 0) corners.push_back({u + u0_, v + v0_});
      heading = next;
      break;
    }
  } while (u != start_u || v != start_v || heading != 0);
  return corners;
}

}  // namespace ribbon_mapper
