// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ribbon_mapper {
namespace {

/// Returns one channel of an HSV colour, all in 0..1. `offset` is 5 for red, 3 for green and 1 for
/// blue, in sixths of the hue circle.
std::uint8_t channel(double offset, double hue, double saturation, double value) {
  const double k = std::fmod(offset + 6.0 * hue, 6.0);
  const double share = std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
  return static_cast<std::uint8_t>(std::lround(255.0 * value * (1.0 - saturation * share)));
}

}  // namespace

Colour plane_colour(std::int64_t id) {
  constexpr double kGoldenRatio = 0.618033988749895;  // distributes any number of hues evenly
  constexpr std::array<double, 3> kSaturations{0.62, 0.45, 0.70};
  constexpr std::array<double, 3> kValues{0.86, 0.93, 0.68};
  const double turns = static_cast<double>(id) * kGoldenRatio;
  const double hue = turns - std::floor(turns);
  const auto tone = static_cast<std::size_t>(((id % 3) + 3) % 3);
  const double saturation = kSaturations[tone], value = kValues[tone];
  return {channel(5.0, hue, saturation, value), channel(3.0, hue, saturation, value),
          channel(1.0, hue, saturation, value)};
}

}  // namespace ribbon_mapper
