// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "modeler/scan/laser_beams.hpp"
#include "modeler/scan/line_averaging.hpp"
#include "modeler/scan/line_buffer.hpp"
#include "modeler/scan/no_return_filter.hpp"
#include "modeler/scan/scan_config.hpp"

namespace ribbon_mapper {

/// What became of a scan line. A line that enters the buffer completes the neighbourhood of earlier
/// ones; the first three results tell what came of these.
enum class LineResult {
  modelled,      ///< it entered the buffer, and ribbons of an earlier line are now in the model
  waiting,       ///< it entered the buffer, but no line has neighbours far enough away yet
  no_ribbons,    ///< it entered the buffer, but the earlier line that it completed has no ribbon
  too_close,     ///< it has hardly moved since the line before it and would only add noise
  no_returns,    ///< not a single range is valid
  malformed,     ///< it has the wrong length, or angles, times or poses that cannot be
  out_of_order,  ///< its stamp is not later than that of the line before it
};

/// Returns the result as words for logs, for example "too close".
const char* to_string(LineResult result);

/// The preprocessing of section 4.1 of the paper: places the beams of each line and pairs lines for
/// the estimation of normals.
///
/// Positions in odom become relative to an origin near the robot, which moves along where the robot
/// leaves its surroundings of 100 m. Lines before and after such a move are not paired.
class ScanFrontEnd {
 public:
  /// Creates a front end without lines. `config` must be valid.
  explicit ScanFrontEnd(const ScanConfig& config);

  /// Adds a line and returns what became of it: `waiting` if it entered the buffer. Only such a
  /// line changes next_three_lines().
  LineResult add(const LaserBeams& raw_beams, const LinePoses& poses);

  /// Returns the most frequent range that stood for no return; nothing if there was none.
  std::optional<NoReturnRange> no_return() const { return no_returns_.found(); }

  /// Returns the next line that has a neighbour on either side, or nothing if there is none yet.
  /// The lines stay valid until the next call of add().
  std::optional<ThreeLines> next_three_lines() { return buffer_.next_three_lines(); }

 private:
  Eigen::Vector3d odom_origin_for(const LinePoses& poses) const;
  bool is_in_order(const ScanLine& line) const;
  bool has_moved(const ScanLine& line) const;
  bool replace_by_average(ScanLine& line, const LaserBeams& beams, const LinePoses& poses);

  ScanConfig config_;
  NoReturnFilter no_returns_;
  LineBuffer buffer_;
  LineAverager averager_;  // the lines since the newest one in the buffer
  Eigen::Vector3d odom_origin_ = Eigen::Vector3d::Zero();  // of the lines in the buffer
};

}  // namespace ribbon_mapper
