// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "bench/recording/recording.hpp"
#include "sim/tour/tour.hpp"

namespace ribbon_mapper::bench {

/// What is to be recorded.
struct TourSource {
  std::string name;
  std::filesystem::path world, route;
  sim::TourConfig config;
};

/// The tour of the paper's experiment: the flat in its hall, drift 3, 380 beams.
TourSource apartment_tour();

/// The same with a wider view: 720 beams, or 1040.
TourSource apartment_tour(int beams);

/// Drives the tour in the simulator, or reads it from `cache` where it was driven before with the
/// same world, route and name.
Recording recording_of(const TourSource& source, const std::filesystem::path& cache);

}  // namespace ribbon_mapper::bench
