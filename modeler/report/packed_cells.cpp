// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/report/packed_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ribbon_mapper {
namespace {

void append_leb128(std::uint64_t value, std::string& bytes) {
  for (; value >= 0x80; value >>= 7) bytes += static_cast<char>((value & 0x7F) | 0x80);
  bytes += static_cast<char>(value);
}

/// Sets the rectangle of all cells.
void set_bounds(const Plane& plane, PackedCells& packed) {
  packed.u_begin = plane.cells.front().u;
  packed.v_begin = plane.cells.front().v;
  std::int64_t u_last = packed.u_begin, v_last = packed.v_begin;
  for (const PlaneCell& cell : plane.cells) {
    packed.u_begin = std::min(packed.u_begin, cell.u);
    packed.v_begin = std::min(packed.v_begin, cell.v);
    u_last = std::max<std::int64_t>(u_last, cell.u);
    v_last = std::max<std::int64_t>(v_last, cell.v);
  }
  packed.columns = u_last - packed.u_begin + 1;
  packed.rows = v_last - packed.v_begin + 1;
}

/// A run of seen cells: the number of its first, and how many there are.
using Run = std::pair<std::int64_t, std::int64_t>;

std::vector<Run> runs_of(const Plane& plane, const PackedCells& packed) {
  std::vector<Run> runs;
  for (const PlaneCell& cell : plane.cells) {
    const std::int64_t number =
        (std::int64_t{cell.v} - packed.v_begin) * packed.columns + cell.u - packed.u_begin;
    if (!runs.empty() && runs.back().first + runs.back().second == number) {
      ++runs.back().second;
    } else {
      runs.emplace_back(number, 1);
    }
  }
  return runs;
}

char packed_mean(float mean_m) {
  if (!std::isfinite(mean_m)) return static_cast<char>(128);
  return static_cast<char>(std::lround(std::clamp(1e3F * mean_m, -127.0F, 127.0F)) + 128);
}

}  // namespace

PackedCells packed_cells(const Plane& plane) {
  PackedCells packed;
  if (plane.cells.empty()) return packed;
  set_bounds(plane, packed);
  const std::vector<Run> runs = runs_of(plane, packed);
  append_leb128(runs.size(), packed.bytes);
  std::int64_t end = 0;
  for (const auto& [first, count] : runs) {
    append_leb128(static_cast<std::uint64_t>(first - end), packed.bytes);
    append_leb128(static_cast<std::uint64_t>(count), packed.bytes);
    end = first + count;
  }
  for (const PlaneCell& cell : plane.cells) packed.bytes += packed_mean(cell.mean_m);
  return packed;
}

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = i; k < i + 3; ++k) {
      group = group << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    }
    for (int shift = 18; shift >= 0; shift -= 6) text += kDigits[group >> shift & 63U];
  }
  if (bytes.size() % 3 != 0)
    text.replace(text.size() - (3 - bytes.size() % 3), 3, "==", 3 - bytes.size() % 3);
  return text;
}

}  // namespace ribbon_mapper
