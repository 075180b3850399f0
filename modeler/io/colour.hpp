// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace ribbon_mapper {

struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
};

/// The colour of a plane wherever planes are shown. Ids that follow each other differ clearly, and
/// none is near white or black, so that planes stand out from the ones before a correction.
Colour plane_colour(std::int64_t id);

}  // namespace ribbon_mapper
