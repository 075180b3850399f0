// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_timing/swept_lines.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/geometry/voxel_key.hpp"
#include "modeler/modeler.hpp"
#include "modeler/scan/no_return_filter.hpp"
#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kMaxDuration_s = 30.0;
constexpr double kMargin_s = 0.1;  // of tf about the lines, for wrong time increments
constexpr double kVoxelsPerRange = 25.0;
constexpr std::size_t kLinesOfSearch = 300, kBeamsOfSearch = 120;

/// Returns the middle one of any values; 0 if there are none.
template <typename Value>
Value median(std::vector<Value> values) {
  if (values.empty()) return Value{};
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_period_s(const std::vector<LaserBeams>& lines) {
  std::vector<double> periods_s;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    periods_s.push_back(to_seconds(lines[i].stamp - lines[i - 1].stamp));
  }
  return median(periods_s);
}

double median_range_m(const std::vector<LaserBeams>& lines, const ScanConfig& config) {
  std::vector<float> ranges_m;
  for (std::size_t i = 0; i < lines.size(); i += 10) {
    for (const float range_m : lines[i].ranges_m) {
      if (is_return(range_m, lines[i], config)) ranges_m.push_back(range_m);
    }
  }
  return median(ranges_m);
}

/// Returns the line with other times.
LaserBeams timed(LaserBeams beams, const LineTiming& timing) {
  beams.stamp += from_seconds(timing.offset_s);
  beams.time_increment_s = timing.time_increment_s;
  return beams;
}

/// Returns every n-th beam of a line, about kBeamsOfSearch.
LaserBeams thinned(const LaserBeams& beams) {
  const std::size_t stride = std::max<std::size_t>(1, beams.ranges_m.size() / kBeamsOfSearch);
  LaserBeams result = beams;
  result.angle_increment_rad *= static_cast<double>(stride);
  result.time_increment_s *= static_cast<double>(stride);
  result.ranges_m.clear();
  for (std::size_t i = 0; i < beams.ranges_m.size(); i += stride) {
    result.ranges_m.push_back(beams.ranges_m[i]);
  }
  return result;
}

}  // namespace

SweptLines::SweptLines(const std::vector<std::filesystem::path>& bags, const BagOptions& options,
                       const ScanConfig& config)
    : config_(config) {
  config_.mixed_pixel_angle_deg = 0.0;  // beams are left out, and steps between them are larger
  LineLog log;
  BagLines source(bags, options, log);
  NoReturnFilter no_returns(config);
  std::string frame;
  double seconds = 0.0;
  while (const std::optional<ReadyLine> line = source.next()) {
    if (!lines_.empty()) seconds = to_seconds(line->beams.stamp - lines_[0].stamp);
    if (seconds > kMaxDuration_s + kMaxOffset_s + kMargin_s) break;
    if (seconds > kMaxDuration_s || find_defect(line->beams, line->poses)) continue;
    frame = line->frame;
    lines_.push_back(no_returns.filter(line->beams));
  }
  if (lines_.empty()) return;
  const Time margin = from_seconds(kMaxOffset_s + kMargin_s);
  track_.emplace(source.buffer(), source.frames(), frame,
                 std::max(Time(0), lines_.front().stamp - margin), end_of(lines_.back()) + margin);
  period_s_ = median_period_s(lines_);
  voxel_m_ = std::max(0.01, median_range_m(lines_, config) / kVoxelsPerRange);
  max_offset_s_ =
      std::min(kMaxOffset_s, 0.25 * to_seconds(lines_.back().stamp - lines_.front().stamp));
  drop_lines_at_the_ends();
}

/// Keeps the lines that all offsets can be compared by.
void SweptLines::drop_lines_at_the_ends() {
  const auto has_poses = [this](const LaserBeams& beams, double offset_s) {
    return track_->poses_of(timed(beams, {offset_s, beams.time_increment_s})).has_value();
  };
  lines_.erase(std::remove_if(lines_.begin(), lines_.end(),
                              [&](const LaserBeams& beams) {
                                return !has_poses(beams, -max_offset_s_) ||
                                       !has_poses(beams, max_offset_s_);
                              }),
               lines_.end());
}

std::size_t SweptLines::occupied_voxels(const LineTiming& timing) const {
  std::vector<VoxelKey> keys;
  ScanLine line;
  const std::size_t stride = std::max<std::size_t>(1, lines_.size() / kLinesOfSearch);
  for (std::size_t i = 0; i < lines_.size(); i += stride) {
    const LaserBeams beams = timed(lines_[i], timing);
    const std::optional<LinePoses> poses = track_->poses_of(beams);
    if (!poses) continue;
    place_beams(thinned(beams), *poses, config_, line);
    for (std::size_t beam = 0; beam < line.size(); ++beam) {
      if (line.has_return(beam)) keys.push_back(voxel_key(line.points[beam], voxel_m_));
    }
  }
  std::sort(keys.begin(), keys.end());
  return static_cast<std::size_t>(std::unique(keys.begin(), keys.end()) - keys.begin());
}

std::optional<double> SweptLines::thickness_m(const LineTiming& timing,
                                              const ModelerConfig& config) const {
  Modeler modeler(config);
  for (const LaserBeams& line : lines_) {
    const LaserBeams beams = timed(line, timing);
    if (const auto poses = track_->poses_of(beams)) modeler.add_scan_line(beams, *poses);
  }
  double points = 0.0, squares = 0.0;
  for (const Plane& plane : modeler.planes()) {
    for (const PlaneCell& cell : plane.cells) {
      points += cell.count;
      squares += cell.count * (cell.mean_m * cell.mean_m + cell.variance_m2);
    }
  }
  if (points == 0.0) return std::nullopt;
  return std::sqrt(squares / points);
}

}  // namespace ribbon_mapper
