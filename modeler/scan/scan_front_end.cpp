// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/scan/scan_front_end.hpp"

#include <cmath>

#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {

const char* to_string(LineResult result) {
  switch (result) {
    case LineResult::modelled:
      return "modelled";
    case LineResult::waiting:
      return "waiting for neighbours";
    case LineResult::no_ribbons:
      return "no ribbons";
    case LineResult::too_close:
      return "too close";
    case LineResult::no_returns:
      return "no returns";
    case LineResult::malformed:
      return "malformed";
    case LineResult::out_of_order:
      return "out of order";
  }
  return "unknown";
}

ScanFrontEnd::ScanFrontEnd(const ScanConfig& config)
    : config_(config),
      no_returns_(config),
      buffer_(config.base_line_sigmas * config.range_sigma_m),
      averager_(config) {}

LineResult ScanFrontEnd::add(const LaserBeams& raw_beams, const LinePoses& poses) {
  if (find_defect(raw_beams, poses)) return LineResult::malformed;
  const LaserBeams& beams = no_returns_.filter(raw_beams);
  ScanLine& line = buffer_.incoming();
  place_beams(beams, poses, config_, line);
  if (!line.has_returns()) return LineResult::no_returns;
  if (buffer_.newest_line()) {
    if (!is_in_order(line)) return LineResult::out_of_order;
    if (!has_moved(line) && !replace_by_average(line, beams, poses)) return LineResult::too_close;
  }
  averager_.clear();
  buffer_.push();
  return LineResult::waiting;
}

bool ScanFrontEnd::is_in_order(const ScanLine& line) const {
  const Time last = averager_.lines() > 0 ? averager_.last_stamp() : buffer_.newest_line()->stamp;
  return line.stamp > last;
}

/// Returns true if the line's beams lie beyond the noise from those of the newest line.
bool ScanFrontEnd::has_moved(const ScanLine& line) const {
  const double step_m = config_.line_step_sigmas * config_.range_sigma_m;
  const double noise_factor = std::sqrt(static_cast<double>(line.averaged_lines));
  return base_line_m(*buffer_.newest_line(), line) >= step_m / noise_factor;
}

/// Adds the beams to the average. Replaces `line` by the average and returns true if that has
/// moved.
bool ScanFrontEnd::replace_by_average(ScanLine& line, const LaserBeams& beams,
                                      const LinePoses& poses) {
  averager_.add(beams, poses);
  if (averager_.lines() < LineAverager::kMinLines) return false;
  place_beams(averager_.average_beams(), averager_.mean_poses(), config_, line);
  line.averaged_lines = averager_.lines();
  return has_moved(line);
}

}  // namespace ribbon_mapper
