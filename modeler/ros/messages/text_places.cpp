// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/messages/text_places.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ribbon_mapper {
namespace {

// Of rviz's font (Liberation Sans), in heights of a capital letter.
constexpr double kLetterWidth = 0.9;
constexpr double kLineHeight = 2.0;

/// Texts one above the other look nearer from above: from 37 degrees, by this factor.
constexpr double kFromAbove = 1.25;

constexpr double kColumn_m = 4.0;    // side of a column; no text counts as wider
constexpr double kMostRise_m = 1.5;  // a text higher up would not be taken for its plane's

int column_of(double value_m) {
  constexpr double kMost = 1e9;  // an int holds it
  return static_cast<int>(std::floor(std::clamp(value_m / kColumn_m, -kMost, kMost)));
}

}  // namespace

TextPlaces::Text TextPlaces::text_at(const Eigen::Vector3d& middle, const std::string& text) const {
  std::istringstream lines(text);
  std::size_t longest = 0, count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    longest = std::max(longest, line.size());
  }
  const double width_m = kLetterWidth * letter_m_ * static_cast<double>(longest);
  return {middle, std::min(width_m, kColumn_m),
          kFromAbove * kLineHeight * letter_m_ * static_cast<double>(count)};
}

const TextPlaces::Text* TextPlaces::covered_by(const Text& text) const {
  const int x = column_of(text.middle.x()), y = column_of(text.middle.y());
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      const auto column = columns_.find({x + dx, y + dy});
      if (column == columns_.end()) continue;
      for (const Text& other : column->second) {
        const Eigen::Vector3d apart = other.middle - text.middle;
        if (apart.head<2>().norm() < 0.5 * (text.width_m + other.width_m) &&
            std::abs(apart.z()) < 0.5 * (text.height_m + other.height_m) - 1e-6)
          return &other;
      }
    }
  }
  return nullptr;
}

Eigen::Vector3d TextPlaces::take(const Eigen::Vector3d& wanted, const std::string& text) {
  Text placed = text_at(wanted, text);
  while (const Text* other = covered_by(placed)) {
    const double higher_m = other->middle.z() + 0.5 * (other->height_m + placed.height_m);
    const bool is_near = higher_m > placed.middle.z() && higher_m <= wanted.z() + kMostRise_m;
    placed.middle.z() = is_near ? higher_m : wanted.z();
    if (!is_near) break;
  }
  columns_[{column_of(wanted.x()), column_of(wanted.y())}].push_back(placed);
  return placed.middle;
}

}  // namespace ribbon_mapper
