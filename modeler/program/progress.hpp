// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace ribbon_mapper {

/// How far a run is, or several together.
struct Progress {
  std::size_t line = 0;   ///< lines done
  std::size_t lines = 0;  ///< of the whole tour
  std::size_t ribbons = 0;
  double tour_s = 0.0;     ///< that the robot has driven
  double modeler_s = 0.0;  ///< that the modeler has worked for that
};
using ProgressCallback = std::function<void(const Progress&)>;

inline Progress operator+(const Progress& a, const Progress& b) {
  return {a.line + b.line, a.lines + b.lines, a.ribbons + b.ribbons, a.tour_s + b.tour_s,
          a.modeler_s + b.modeler_s};
}

/// Seconds of tour per second of the modeler's work.
inline double real_time_factor(const Progress& progress) {
  return progress.modeler_s > 0.0 ? progress.tour_s / progress.modeler_s : 0.0;
}

}  // namespace ribbon_mapper
