// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/line_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "modeler/scan/beam_match.hpp"

namespace ribbon_mapper {
namespace {

/// Returns the square of the component of `moved` that is normal to the scan plane at `beam`.
double square_across(const Eigen::Vector3d& moved, const ScanLine& line, std::size_t beam) {
  const std::size_t neighbour = beam + 1 < line.size() ? beam + 1 : beam - 1;
  const Eigen::Vector3d across = line.directions[beam].cross(line.directions[neighbour]);
  const double part = moved.dot(across);
  return part * part / across.squaredNorm();
}

bool turn_opposite_ways(const ScanLine& a, const ScanLine& b) {
  return a.angle_increment_rad * b.angle_increment_rad < 0.0;
}

}  // namespace

void LineBuffer::push() {
  const std::size_t incoming = (newest_ + 1) % kSlots;
  if (count_ > 0 && turn_opposite_ways(lines_[incoming], lines_[newest_])) clear();
  newest_ = incoming;
  if (count_ < kSlots - 1) {
    ++count_;
  } else if (done_ > 0) {
    --done_;  // the next incoming line overwrites the oldest one
  }
}

std::optional<ThreeLines> LineBuffer::next_three_lines() {
  for (; done_ + 1 < count_; ++done_) {
    const std::size_t age = count_ - 1 - done_;
    const ScanLine& line = lines_[slot(age)];
    std::size_t before = age + 1, after = age;
    while (before < count_ && !are_apart(lines_[slot(before)], line)) ++before;
    if (before == count_) continue;  // one of the first lines, or the tilt reverses here
    do {
      if (after-- == 0) return std::nullopt;
    } while (!are_apart(line, lines_[slot(after)]));
    ++done_;
    return ThreeLines{lines_[slot(before)], line, lines_[slot(after)]};
  }
  return std::nullopt;
}

/// An averaged line has less noise, so its base line may be shorter.
bool LineBuffer::are_apart(const ScanLine& before, const ScanLine& line) const {
  const auto averaged = static_cast<double>(std::min(before.averaged_lines, line.averaged_lines));
  return ribbon_mapper::base_line_m(before, line) >= base_line_m_ / std::sqrt(averaged);
}

double base_line_m(const ScanLine& before, const ScanLine& line) {
  if (before.size() < 2 || line.size() < 2 || turn_opposite_ways(before, line)) {
    return std::numeric_limits<double>::infinity();
  }
  constexpr std::size_t samples = 32;
  const BeamMatch match(line, before);
  std::array<double, samples> squares;
  std::size_t count = 0;
  bool have_common_bearings = false;
  const Eigen::Vector3d of_first = line.first_origin - before.first_origin;
  const Eigen::Vector3d per_beam = line.origin_step - before.origin_step;
  const std::size_t stride = (line.size() + samples - 1) / samples;
  for (std::size_t i = 0; i < line.size() && count < samples; i += stride) {
    const std::int64_t at = match.nearest(i);
    if (at < 0 || at >= static_cast<std::int64_t>(before.size())) continue;
    have_common_bearings = true;
    if (!line.has_return(i)) continue;
    const auto other = static_cast<std::size_t>(at);
    Eigen::Vector3d moved = of_first + static_cast<double>(i) * per_beam +
                            line.ranges_m[i] * (line.directions[i] - before.directions[other]);
    if (!match.is_by_index()) {
      const double beams_apart = static_cast<double>(i) - static_cast<double>(other);
      moved += beams_apart * before.origin_step;
    }
    squares[count++] = square_across(moved, before, other);
  }
  if (!have_common_bearings) return std::numeric_limits<double>::infinity();
  if (count == 0) return 0.0;
  std::nth_element(squares.begin(), squares.begin() + count / 2, squares.begin() + count);
  return std::sqrt(squares[count / 2]);
}

}  // namespace ribbon_mapper
