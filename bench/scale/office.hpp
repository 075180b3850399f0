// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "bench/recording/tour_recording.hpp"

namespace ribbon_mapper::bench {

/// Writes the world of an office floor into `directory`, with a route through all rooms and back.
/// `rooms`, an even number, furnished rooms of 5 x 4 m lie on both sides of a corridor. The files
/// are reproducible to the byte.
TourSource office_tour(int rooms, const std::filesystem::path& directory);

}  // namespace ribbon_mapper::bench
