// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/line_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ribbon_mapper {
namespace {

/// Normal of the plane that the beams next to `beam` sweep.
Eigen::Vector3d across(const ScanLine& line, std::size_t beam) {
  const std::size_t neighbour = beam + 1 < line.size() ? beam + 1 : beam - 1;
  return line.directions[beam].cross(line.directions[neighbour]).normalized();
}

}  // namespace

void LineBuffer::push() {
  const std::size_t incoming = (newest_ + 1) % 4;
  if (count_ > 0 && lines_[incoming].size() != lines_[newest_].size()) count_ = 0;
  newest_ = incoming;
  count_ = std::min<std::size_t>(count_ + 1, 3);
}

void LineBuffer::clear() { count_ = 0; }

double base_line_m(const ScanLine& before, const ScanLine& line) {
  if (before.size() != line.size() || line.size() < 2) return std::numeric_limits<double>::infinity();
  constexpr std::size_t samples = 32;
  std::array<double, samples> distances;
  std::size_t count = 0;
  const std::size_t stride = std::max<std::size_t>(1, line.size() / samples);
  for (std::size_t i = 0; i < line.size() && count < samples; i += stride) {
    if (!line.has_return(i)) continue;
    const Eigen::Vector3d moved = line.origins[i] - before.origins[i] +
                                  line.ranges_m[i] * (line.directions[i] - before.directions[i]);
    distances[count++] = std::abs(moved.dot(across(before, i)));
  }
  if (count == 0) return 0.0;
  std::nth_element(distances.begin(), distances.begin() + count / 2, distances.begin() + count);
  return distances[count / 2];
}

}  // namespace ribbon_mapper
