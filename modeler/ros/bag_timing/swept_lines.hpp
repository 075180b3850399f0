// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "modeler/modeler_config.hpp"
#include "modeler/ros/bag/bag_lines.hpp"
#include "modeler/ros/bag_timing/pose_track.hpp"

namespace ribbon_mapper {

/// A change of the times of all beams.
struct LineTiming {
  double offset_s = 0.0;          ///< added to the stamps
  double time_increment_s = 0.0;  ///< from each beam to the next
};

/// The lines of the first half minute of a recording, to be placed as if their times were others.
class SweptLines {
 public:
  /// Largest offset of the laser's stamps that can be asked about, in either direction: a second,
  /// and a little more to see that it fits best.
  static constexpr double kMaxOffset_s = 1.05;

  /// Reads the lines that have poses. Throws what BagLines throws.
  SweptLines(const std::vector<std::filesystem::path>& bags, const BagOptions& options,
             const ScanConfig& config);

  /// Returns the number of lines that have poses with every offset up to max_offset_s().
  std::size_t size() const { return lines_.size(); }
  /// Returns the largest offset that the recording can be asked about. It is shorter than
  /// kMaxOffset_s for a recording of a few seconds.
  double max_offset_s() const { return max_offset_s_; }
  /// Returns the median time between successive lines.
  double period_s() const { return period_s_; }
  /// Returns the beams of the first line.
  const LaserBeams& first_beams() const { return lines_.front(); }

  /// Returns the number of voxels that the returns lie in. It is smallest if up and down sweeps
  /// agree. Voxels have a width of 1/25 of the median range.
  std::size_t occupied_voxels(const LineTiming& timing) const;

  /// Returns the root mean square distance of the points from the planes that they make; nothing if
  /// there are none.
  std::optional<double> thickness_m(const LineTiming& timing, const ModelerConfig& config) const;

 private:
  void drop_lines_at_the_ends();

  ScanConfig config_;
  std::optional<PoseTrack> track_;
  std::vector<LaserBeams> lines_;
  double max_offset_s_ = kMaxOffset_s, period_s_ = 0.0, voxel_m_ = 0.1;
};

}  // namespace ribbon_mapper
