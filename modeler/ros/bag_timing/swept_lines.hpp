// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "modeler/modeler_config.hpp"
#include "modeler/ros/bag/bag_lines.hpp"
#include "modeler/ros/bag_timing/pose_track.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// A change of the times of all beams.
struct LineTiming {
  double offset_s = 0.0;          ///< added to the stamps
  double time_increment_s = 0.0;  ///< from each beam to the next
};

/// How thick the planes of points are, for several parts of a recording.
class PlaneThickness {
 public:
  /// Adds the planes of the next part.
  void add(const std::vector<Plane>& planes);
  /// Returns the root mean square distance of all points from their planes; nothing without points.
  std::optional<double> rms_m() const;
  /// Returns true if these planes are thinner than those of the same parts at other times, by more
  /// than chance: in the mean over the parts by two standard errors.
  bool is_thinner_than(const PlaneThickness& other) const;

 private:
  struct Part {
    double points = 0.0, squares_m2 = 0.0;
  };
  std::vector<Part> parts_;
};

/// The lines of the first half minute of a recording, or of a few periods of a slow tilt, to be
/// placed as if their times were others.
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

  /// Returns the thickness of the planes in each period of the tilt, or in a few of them. Each
  /// makes planes of its own, by odometry, so that neither drift nor jumps of a localisation count.
  PlaneThickness thickness(const LineTiming& timing, const ModelerConfig& config) const;

 private:
  void drop_lines_at_the_ends();
  Time few_periods() const;

  ScanConfig config_;
  std::optional<PoseTrack> track_;
  std::vector<LaserBeams> lines_;
  double max_offset_s_ = kMaxOffset_s, period_s_ = 0.0, voxel_m_ = 0.1;
  Time window_{0};  // of the lines that make planes together
};

}  // namespace ribbon_mapper
