// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "bench/recording/recording.hpp"
#include "sim/tour/tour.hpp"

namespace ribbon_mapper::bench {

/// A simulated tour to record.
struct TourSource {
  std::string name;             ///< for the report and the cache
  std::filesystem::path world;  ///< SDF file
  std::filesystem::path route;  ///< route file
  sim::TourConfig config;       ///< noise, laser and robot
};

/// Returns the tour of the paper's experiment through the apartment: drift 3, 380 beams.
TourSource apartment_tour();

/// Returns the same tour with a wider field of view of `beams` beams.
TourSource apartment_tour(int beams);

/// Records the tour in the simulator, or reads it from the folder `cache` if it has been recorded
/// with the same world, route and name.
Recording recording_of(const TourSource& source, const std::filesystem::path& cache);

}  // namespace ribbon_mapper::bench
