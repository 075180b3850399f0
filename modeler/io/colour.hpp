// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ribbon_mapper {

/// An RGB colour.
struct Colour {
  std::uint8_t red = 0;    ///< 0 to 255
  std::uint8_t green = 0;  ///< 0 to 255
  std::uint8_t blue = 0;   ///< 0 to 255
};

/// Returns the colour of a plane, the same in all outputs. Consecutive ids differ clearly, and no
/// colour is near white, grey or black, which are used for planes before a correction.
Colour plane_colour(std::int64_t id);

}  // namespace ribbon_mapper
