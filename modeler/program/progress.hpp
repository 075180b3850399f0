// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace ribbon_mapper {

/// Progress of one run, or the sum over several.
struct Progress {
  std::size_t line = 0;     ///< lines done
  std::size_t lines = 0;    ///< lines of the whole tour
  std::size_t ribbons = 0;  ///< ribbons in the model
  double tour_s = 0.0;      ///< time driven so far
  double modeler_s = 0.0;   ///< computing time of the modeler so far
};

/// Function that is called with the progress after each line.
using ProgressCallback = std::function<void(const Progress&)>;

/// Adds up the progress of two runs.
inline Progress operator+(const Progress& a, const Progress& b) {
  return {a.line + b.line, a.lines + b.lines, a.ribbons + b.ribbons, a.tour_s + b.tour_s,
          a.modeler_s + b.modeler_s};
}

/// Returns the seconds of tour per second of computing, 0 before the first line.
inline double real_time_factor(const Progress& progress) {
  return progress.modeler_s > 0.0 ? progress.tour_s / progress.modeler_s : 0.0;
}

}  // namespace ribbon_mapper
