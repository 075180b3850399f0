// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

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
  /// The lines that wait for their neighbours, and what earlier ones have shown.
  struct Parts {
    /// A line in the buffer.
    struct Line {
      LaserBeams beams;                ///< what it was placed from
      LinePoses poses;                 ///< relative to the origin
      std::size_t averaged_lines = 1;  ///< number of lines that it is the mean of
    };
    std::optional<Time> last_stamp;  ///< lines that are not later are out of order
    Eigen::Vector3d odom_origin = Eigen::Vector3d::Zero();  ///< of the lines, in odom [m]
    std::vector<Line> lines;                                ///< in their order
    std::size_t done = 0;                 ///< the first of them: they need no later lines
    LineAverager::Sums average;           ///< of the lines since the last one
    NoReturnFilter::Evidence no_returns;  ///< of all lines so far
  };

  /// Creates a front end without lines. `config` must be valid.
  explicit ScanFrontEnd(const ScanConfig& config) : ScanFrontEnd(config, Parts()) {}

  /// Goes on from the parts of a front end. Where the next line comes more than a second later, the
  /// waiting lines are forgotten: odometry may have begun anew since.
  ScanFrontEnd(const ScanConfig& config, Parts parts);

  /// Returns all that decides what becomes of the next lines.
  Parts parts() const;

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
  Time newest_stamp() const;
  bool is_in_order(const ScanLine& line) const;
  void forget_after_pause(Time stamp);
  bool has_moved(const ScanLine& line) const;
  bool replace_by_average(ScanLine& line, const LaserBeams& beams, const LinePoses& poses);

  ScanConfig config_;
  std::optional<Time> last_stamp_;  // of lines before the first one in the buffer
  bool is_resumed_;                 // the lines are of parts, and none has been added since
  NoReturnFilter no_returns_;
  LineBuffer buffer_;
  LineAverager averager_;  // the lines since the newest one in the buffer
  Eigen::Vector3d odom_origin_ = Eigen::Vector3d::Zero();  // of the lines in the buffer
};

}  // namespace ribbon_mapper
