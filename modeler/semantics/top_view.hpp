// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "modeler/geometry/grid_keys.hpp"

namespace ribbon_mapper {

/// The part of a plane in one square of a TopView.
struct PlanePart {
  std::size_t plane;  ///< index of the plane
  double lowest_m;    ///< height of its lowest cell
  double highest_m;   ///< height of its highest cell
};

/// What lies where, seen from above, in squares.
template <typename Item>
class TopView {
 public:
  /// Creates an empty view with squares of this side.
  explicit TopView(double square_m) : square_m_(square_m) {}

  /// Returns what lies in the square around a place.
  std::vector<Item>& at(const Eigen::Vector2d& place) {
    return squares_[key_of(column(place.x()), column(place.y()))];
  }

  /// Calls `visit` with each item in the squares that are up to `rings` squares away.
  template <typename Visit>
  void for_each_around(const Eigen::Vector2d& place, int rings, const Visit& visit) const {
    const std::int32_t x = column(place.x()), y = column(place.y());
    for (std::int32_t dx = -rings; dx <= rings; ++dx) {
      for (std::int32_t dy = -rings; dy <= rings; ++dy) {
        const auto found = squares_.find(key_of(x + dx, y + dy));
        if (found == squares_.end()) continue;
        for (const Item& item : found->second) visit(item);
      }
    }
  }

  /// Returns the side of a square [m].
  double square_m() const { return square_m_; }

 private:
  std::int32_t column(double x_m) const { return floor_to_int(x_m / square_m_); }
  static std::uint64_t key_of(std::int32_t x, std::int32_t y) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32) |
           static_cast<std::uint32_t>(y);
  }

  double square_m_;
  std::unordered_map<std::uint64_t, std::vector<Item>, KeyHash> squares_;
};

}  // namespace ribbon_mapper
