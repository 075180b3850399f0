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

constexpr Time kMinDuration = std::chrono::seconds(30);
constexpr double kMaxDuration_s = 60.0;
constexpr double kMargin_s = 0.1;  // of tf about the lines, for wrong time increments
constexpr double kVoxelsPerRange = 25.0;
constexpr std::size_t kLinesOfSearch = 300, kBeamsOfSearch = 120;
constexpr double kMinLinesEachWay = 50.0;  // up and down, of the planes that are made together
constexpr int kWindows = 6;                // that chance is told by, in a longer recording

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

/// Returns the poses with the odometry as map.
LinePoses by_odometry(LinePoses poses) {
  poses.T_map_base = interpolate(poses.T_odom_base_first, poses.T_odom_base_last, 0.5);
  return poses;
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
  if (lines_.empty()) return;
  window_ = few_periods();
  const Time last = lines_.front().stamp + std::max(kMinDuration, kWindows * window_);
  while (lines_.back().stamp > last) lines_.pop_back();
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

/// Returns the duration of as many periods of the tilt as have enough lines each way; of the whole
/// recording if the laser stands still or turns in one direction only.
Time SweptLines::few_periods() const {
  std::vector<Eigen::Quaterniond> orientations;
  for (const LaserBeams& line : lines_) {
    orientations.emplace_back(track_->poses_of(line)->T_base_laser_first.linear());
  }
  const auto furthest_from = [&](const Eigen::Quaterniond& from) {
    return *std::max_element(orientations.begin(), orientations.end(),
                             [&](const auto& a, const auto& b) {
                               return from.angularDistance(a) < from.angularDistance(b);
                             });
  };
  const Time duration = lines_.back().stamp - lines_.front().stamp;
  const Eigen::Quaterniond end = furthest_from(orientations.front());
  const double span_rad = end.angularDistance(furthest_from(end));
  if (!(span_rad > 0.0)) return duration + Time(1);
  double way_rad = 0.0, lines_there = 0.0, lines_back = 0.0;
  for (std::size_t i = 1; i < orientations.size(); ++i) {
    way_rad += orientations[i - 1].angularDistance(orientations[i]);
    const bool is_back =
        end.angularDistance(orientations[i]) > end.angularDistance(orientations[i - 1]);
    (is_back ? lines_back : lines_there) += 1.0;
  }
  const double periods = 0.5 * way_rad / span_rad;
  const double lines_each_way = std::min(lines_there, lines_back) / periods;
  if (!(lines_each_way > 0.0)) return duration + Time(1);
  return from_seconds(std::ceil(kMinLinesEachWay / lines_each_way) * to_seconds(duration) /
                      periods);
}

std::size_t SweptLines::occupied_voxels(const LineTiming& timing) const {
  std::vector<VoxelKey> keys;
  ScanLine line;
  const Time end = lines_.front().stamp + kMinDuration;
  const auto count = static_cast<std::size_t>(std::count_if(
      lines_.begin(), lines_.end(), [&](const LaserBeams& beams) { return beams.stamp <= end; }));
  const std::size_t stride = std::max<std::size_t>(1, count / kLinesOfSearch);
  for (std::size_t i = 0; i < count; i += stride) {
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

PlaneThickness SweptLines::thickness(const LineTiming& timing, const ModelerConfig& config) const {
  PlaneThickness result;
  for (auto line = lines_.begin(); line != lines_.end();) {
    Modeler modeler(config);
    const Time end = line->stamp + window_;
    for (; line != lines_.end() && line->stamp < end; ++line) {
      const LaserBeams beams = timed(*line, timing);
      if (const auto poses = track_->poses_of(beams)) {
        modeler.add_scan_line(beams, by_odometry(*poses));
      }
    }
    result.add(modeler.planes());
  }
  return result;
}

void PlaneThickness::add(const std::vector<Plane>& planes) {
  Part& part = parts_.emplace_back();
  for (const Plane& plane : planes) {
    for (const PlaneCell& cell : plane.cells) {
      part.points += cell.count;
      part.squares_m2 += cell.count * (cell.mean_m * cell.mean_m + cell.variance_m2);
    }
  }
}

std::optional<double> PlaneThickness::rms_m() const {
  Part all;
  for (const Part& part : parts_) {
    all.points += part.points, all.squares_m2 += part.squares_m2;
  }
  if (all.points == 0.0) return std::nullopt;
  return std::sqrt(all.squares_m2 / all.points);
}

bool PlaneThickness::is_thinner_than(const PlaneThickness& other) const {
  double count = 0.0, sum = 0.0, square_sum = 0.0;
  for (std::size_t i = 0; i < std::min(parts_.size(), other.parts_.size()); ++i) {
    const Part &own = parts_[i], &theirs = other.parts_[i];
    if (own.points == 0.0 || theirs.points == 0.0) continue;
    const double gain_m2 = theirs.squares_m2 / theirs.points - own.squares_m2 / own.points;
    count += 1.0, sum += gain_m2, square_sum += gain_m2 * gain_m2;
  }
  if (count < 2.0) return sum > 0.0;
  const double variance = (square_sum - sum * sum / count) / (count - 1.0);
  return sum > 2.0 * std::sqrt(count * std::max(0.0, variance));
}

}  // namespace ribbon_mapper
