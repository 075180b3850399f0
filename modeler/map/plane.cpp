// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/plane.hpp"

#include <algorithm>

namespace ribbon_mapper {
namespace {

/// The seen cells as a picture with a margin, closed (dilated, then eroded) by a square.
class Bitmap {
 public:
  Bitmap(const std::vector<PlaneCell>& cells, int margin) : margin_(margin) {
    int u_max = cells.front().u, v_max = cells.front().v;
    u0_ = u_max, v0_ = v_max;
    for (const PlaneCell& cell : cells) {
      u0_ = std::min(u0_, cell.u), u_max = std::max(u_max, cell.u);
      v0_ = std::min(v0_, cell.v), v_max = std::max(v_max, cell.v);
    }
    u0_ -= margin, v0_ -= margin;
    columns_ = u_max - u0_ + margin + 1, rows_ = v_max - v0_ + margin + 1;
    seen_.assign(static_cast<std::size_t>(columns_) * rows_, 0);
    for (const PlaneCell& cell : cells) at(cell.u - u0_, cell.v - v0_) = 1;
  }

  void close() {
    spread(1, 1, columns_, rows_), spread(1, columns_, rows_, columns_);
    spread(0, 1, columns_, rows_), spread(0, columns_, rows_, columns_);
  }

  /// Runs of each row; runs alike in successive rows become one rectangle.
  std::vector<CellRectangle> rectangles() {
    std::vector<CellRectangle> done, open;
    for (int v = 0; v <= rows_; ++v) {
      std::vector<CellRectangle> now;
      for (int u = 0; v < rows_ && u < columns_; ++u) {
        if (!at(u, v)) continue;
        CellRectangle run{u + u0_, u + u0_, v + v0_, v + v0_ + 1};
        while (u < columns_ && at(u, v)) ++u;
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

 private:
  char& at(int u, int v) { return seen_[static_cast<std::size_t>(v) * columns_ + u]; }

  /// Sets to `value` all within the margin of a cell of that value, along lines of `length` cells
  /// that are `step` apart; beyond the picture nothing is seen.
  void spread(char value, std::size_t step, int length, int lines) {
    const std::size_t line_step = step == 1 ? columns_ : 1;
    for (int k = 0; k < lines; ++k) {
      char* line = seen_.data() + k * line_step;
      int reach = value ? -1 : margin_;
      std::vector<char> out(length);
      for (int pass = 0; pass < 2; ++pass) {
        reach = value ? -1 : margin_;
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

  int margin_, u0_, v0_, columns_, rows_;
  std::vector<char> seen_;
};

}  // namespace

std::vector<CellRectangle> surface_rectangles(const Plane& plane, double closing_m) {
  if (plane.cells.empty()) return {};
  Bitmap bitmap(plane.cells, static_cast<int>(0.5 * closing_m / plane.cell_size_m));
  bitmap.close();
  return bitmap.rectangles();
}

}  // namespace ribbon_mapper
