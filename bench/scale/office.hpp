// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "bench/recording/tour_recording.hpp"

namespace ribbon_mapper::bench {

/// An office floor: `rooms` of 5 x 4 m (an even number) on both sides of a corridor, furnished, and
/// a route through all of them and back. Writes the world and the route into `directory`. The same
/// number gives the same bytes.
TourSource office_tour(int rooms, const std::filesystem::path& directory);

}  // namespace ribbon_mapper::bench
