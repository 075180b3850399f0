// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/scale/tiles.hpp"

#include <algorithm>
#include <cmath>

#include "bench/stopwatch.hpp"

namespace ribbon_mapper::bench {

Tiles::Tiles(const Recording& piece, double spacing_m, std::size_t side)
    : piece_(piece), spacing_m_(spacing_m), side_(side) {
  for (const RecordedLine& line : piece.lines) centre_ += line.T_map_base_true.translation();
  centre_ /= static_cast<double>(piece.lines.size());
}

Pose Tiles::T_map_tile(std::size_t k) const {
  Pose T = Pose::Identity();
  T.translation() = spacing_m_ * Eigen::Vector3d(static_cast<double>(k % side_),
                                                 static_cast<double>(k / side_), 0.0);
  return T;
}

Time Tiles::start_of(std::size_t k) const {
  const Time lasting = piece_.lines.back().beams.stamp - piece_.lines.front().beams.stamp;
  return static_cast<Time::rep>(k) * (lasting + from_seconds(1.0));
}

double Tiles::feed(std::size_t k, Modeler& modeler) const {
  const Pose T = T_map_tile(k);
  double seconds = 0.0;
  for (const RecordedLine& line : piece_.lines) {
    LaserBeams beams = line.beams;
    beams.stamp += start_of(k);
    LinePoses poses = line.poses;
    poses.T_map_base = T * poses.T_map_base;
    seconds += cpu_seconds_of([&] { modeler.add_scan_line(beams, poses); });
  }
  return seconds / static_cast<double>(piece_.lines.size());
}

std::vector<StampedPose> Tiles::truth(std::size_t count) const {
  std::vector<StampedPose> trajectory;
  for (std::size_t k = 0; k < count; ++k) {
    for (const StampedPose& pose : true_trajectory(piece_)) {
      trajectory.push_back({pose.stamp + start_of(k), T_map_tile(k) * pose.T_map_base});
    }
  }
  return trajectory;
}

std::size_t Tiles::tile_at(const Eigen::Vector3d& place) const {
  const auto step = [&](int axis) {
    const double steps = std::round((place[axis] - centre_[axis]) / spacing_m_);
    return static_cast<std::size_t>(std::max(0.0, steps));
  };
  return step(1) * side_ + std::min(step(0), side_ - 1);
}

std::vector<eval::MapMetrics> Tiles::judged(const std::vector<Plane>& planes,
                                            std::size_t count) const {
  std::vector<std::vector<eval::Patch>> by_tile(count);
  for (const Plane& plane : planes) {
    const std::size_t k = tile_at(plane.centroid);
    if (k >= count) continue;
    const Eigen::Vector3d shift = T_map_tile(k).translation();
    eval::Patch& patch = by_tile[k].emplace_back(eval::patch_of(plane));
    patch.d_m += patch.normal.dot(shift);
    for (Eigen::Vector3d& cell : patch.cells) cell -= shift;
  }
  std::vector<eval::MapMetrics> results;
  for (const auto& patches : by_tile) results.push_back(compare_maps(patches, piece_.truth));
  return results;
}

std::vector<StampedPose> bent(std::vector<StampedPose> trajectory, double share) {
  const auto size = static_cast<double>(trajectory.size());
  const auto first = static_cast<std::size_t>(size * (1.0 - share));
  for (std::size_t i = first; i < trajectory.size(); ++i) {
    const double way = static_cast<double>(i - first + 1) / (size * share);
    Pose& pose = trajectory[i].T_map_base;
    pose = pose * planar_pose(0.03 * std::sin(9.0 * way), 0.02 * way, 0.008 * std::sin(5.0 * way));
  }
  return trajectory;
}

double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double lx = std::log(x[i]), ly = std::log(y[i]);
    sx += lx, sy += ly, sxx += lx * lx, sxy += lx * ly;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace ribbon_mapper::bench
