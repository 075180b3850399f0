// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/surface/cell_bitmap.hpp"

#include <algorithm>

namespace ribbon_mapper {
namespace {

using Words = std::vector<std::uint64_t>;

void set_bit(Words& words, std::size_t i) { words[i / 64] |= std::uint64_t{1} << (i % 64); }

void clear_bit(Words& words, std::size_t i) { words[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }

/// Replaces each bit by its combination with the one `shift` bits ahead. Bits beyond the end are 0.
template <typename Join>
void join_ahead(Words& words, std::size_t shift, const Join& join) {
  const std::size_t skip = shift / 64, low = shift % 64;
  const auto word = [&](std::size_t i) { return i < words.size() ? words[i] : 0; };
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::uint64_t next = low > 0 ? word(i + skip + 1) << (64 - low) : 0;
    words[i] = join(words[i], (word(i + skip) >> low) | next);
  }
}

/// Replaces each bit by its combination with the one `shift` bits behind. Bits before the start are
/// 0.
template <typename Join>
void join_behind(Words& words, std::size_t shift, const Join& join) {
  const std::size_t skip = shift / 64, low = shift % 64;
  const auto word = [&](std::size_t i) {
    return i < words.size() ? words[i] : 0;
  };  // wraps round: i < skip
  for (std::size_t i = words.size(); i-- > 0;) {
    const std::uint64_t next = low > 0 ? word(i - skip - 1) >> (64 - low) : 0;
    words[i] = join(words[i], (word(i - skip) << low) | next);
  }
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
  columns_ = u_max - u0_ + margin + 2, rows_ = v_max - v0_ + margin + 1;
  seen_.assign(index(0, rows_) / 64 + 1, 0);
  for (const PlaneCell& cell : cells) set_bit(seen_, index(cell.u - u0_, cell.v - v0_));
}

void CellBitmap::close() {
  join_neighbours([](std::uint64_t a, std::uint64_t b) { return a | b; });
  join_neighbours([](std::uint64_t a, std::uint64_t b) { return a & b; });
}

/// Replaces each cell by the combination of all cells within the margin, along rows, then columns.
/// Cells beyond the bitmap are unseen. The number of combined cells doubles in each step.
template <typename Join>
void CellBitmap::join_neighbours(const Join& join) {
  for (const std::size_t step : {std::size_t{1}, index(0, 1)}) {
    for (int joined = 1, more = 0; joined <= margin_; joined += more) {
      more = std::min(joined, margin_ + 1 - joined);
      join_ahead(seen_, more * step, join);
    }
    for (int joined = 1, more = 0; joined <= margin_; joined += more) {
      more = std::min(joined, margin_ + 1 - joined);
      join_behind(seen_, more * step, join);
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

void CellBitmap::join_corners() {
  const auto ahead = [this](std::size_t shift) {
    Words words = seen_;
    join_ahead(words, shift, [](auto, auto next) { return next; });
    return words;
  };
  for (bool changed = true; changed;) {
    changed = false;
    const Words right = ahead(1), above = ahead(index(0, 1)), across = ahead(index(1, 1));
    Words rising(seen_.size());  // cells that touch the one to the upper right: fills the right one
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      rising[i] = seen_[i] & across[i] & ~right[i] & ~above[i];
      const std::uint64_t falling = right[i] & above[i] & ~seen_[i] & ~across[i];
      seen_[i] |= falling;
      changed = changed || (rising[i] | falling) != 0;
    }
    join_behind(rising, 1, [](auto, auto before) { return before; });
    for (std::size_t i = 0; i < seen_.size(); ++i) seen_[i] |= rising[i];
  }
}

std::vector<std::vector<GridCorner>> CellBitmap::boundaries() const {
  Words lower_edges = seen_;  // lower edges of seen cells that no boundary has followed yet
  join_behind(lower_edges, index(0, 1), [](auto cell, auto below) { return cell & ~below; });
  std::vector<std::vector<GridCorner>> boundaries;
  for (std::size_t i = 0; i < lower_edges.size(); ++i) {
    while (lower_edges[i] != 0) {
      const auto at = 64 * i + static_cast<std::size_t>(__builtin_ctzll(lower_edges[i]));
      const auto columns = static_cast<std::size_t>(columns_);
      boundaries.push_back(
          follow(static_cast<int>(at % columns), static_cast<int>(at / columns), lower_edges));
    }
  }
  return boundaries;
}

/// Follows the boundary with seen cells to its left, starting at the lower edge of cell (u, v).
/// Clears the lower edges that it passes.
std::vector<GridCorner> CellBitmap::follow(int u, int v, Words& lower_edges) const {
  constexpr int step_u[] = {1, 0, -1, 0}, step_v[] = {0, 1, 0, -1};
  constexpr int left_u[] = {0, -1, -1, 0},
                left_v[] = {0, 0, -1, -1};  // the cell to the left of a step
  const int start_u = u, start_v = v;
  int heading = 0;
  std::vector<GridCorner> corners;
  do {
    if (heading == 0) clear_bit(lower_edges, index(u, v));
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
