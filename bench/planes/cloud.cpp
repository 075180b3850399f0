// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/planes/cloud.hpp"

#include <cmath>
#include <limits>

#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper::bench {
namespace {

constexpr float kVoxel_m = 0.05F;

/// Returns the transform from odom to map by the noisy or the true acquisition pose of a line.
Pose T_map_odom(const RecordedLine& recorded, const ScanLine& line, Poses poses) {
  const Pose& T_map_base =
      poses == Poses::truth ? recorded.T_map_base_true : recorded.poses.T_map_base;
  return T_map_base * line.T_odom_base.inverse(Eigen::Isometry);
}

}  // namespace

TourCloud cloud_of(const Recording& tour, const ScanConfig& config, Poses poses) {
  TourCloud cloud;
  cloud.points.reserve(tour.beam_count());
  cloud.sensors.reserve(tour.beam_count());
  ScanLine line;
  for (const RecordedLine& recorded : tour.lines) {
    place_beams(recorded.beams, recorded.poses, config, line);
    const Pose T = T_map_odom(recorded, line, poses);
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (!line.has_return(i)) continue;
      cloud.points.push_back((T * line.points[i]).cast<float>());
      cloud.sensors.push_back((T * line.origin(i)).cast<float>());
    }
  }
  return cloud;
}

std::vector<Sweep> sweeps_of(const Recording& tour, const ScanConfig& config, Poses poses,
                             std::size_t lines_per_sweep) {
  std::vector<Sweep> sweeps;
  ScanLine line;
  for (std::size_t first = 0; first + lines_per_sweep <= tour.lines.size();
       first += lines_per_sweep) {
    const RecordedLine& centre = tour.lines[first + lines_per_sweep / 2];
    place_beams(centre.beams, centre.poses, config, line);
    Sweep& sweep = sweeps.emplace_back();
    const std::size_t middle = line.size() / 2;
    sweep.width = line.size();
    Pose T_odom_image = Pose::Identity();
    T_odom_image.linear() =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), line.directions[middle])
            .toRotationMatrix();
    T_odom_image.translation() = line.origin(middle);
    sweep.T_map_image = T_map_odom(centre, line, poses) * T_odom_image;
    const Pose T_image_map = sweep.T_map_image.inverse(Eigen::Isometry);
    for (std::size_t k = first; k < first + lines_per_sweep; ++k) {
      place_beams(tour.lines[k].beams, tour.lines[k].poses, config, line);
      const Pose T = T_image_map * T_map_odom(tour.lines[k], line, poses);
      for (std::size_t i = 0; i < line.size(); ++i) {
        const float none = std::numeric_limits<float>::quiet_NaN();
        sweep.pixels.push_back(line.has_return(i) ? (T * line.points[i]).cast<float>().eval()
                                                  : Eigen::Vector3f::Constant(none).eval());
      }
    }
  }
  return sweeps;
}

ViewField::ViewField(const TourCloud& cloud) {
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    auto& sum = sums_.try_emplace(key_of(cloud.points[i]), Eigen::Vector3f::Zero()).first->second;
    sum += (cloud.sensors[i] - cloud.points[i]).normalized();
  }
}

std::uint64_t ViewField::key_of(const Eigen::Vector3f& point) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto index = static_cast<std::int64_t>(std::floor(point[axis] / kVoxel_m));
    key = (key << 21) | static_cast<std::uint64_t>(index & 0x1fffff);
  }
  return key;
}

Eigen::Vector3f ViewField::towards_sensor(const Eigen::Vector3f& point) const {
  const auto found = sums_.find(key_of(point));
  return found == sums_.end() ? Eigen::Vector3f::Zero().eval() : found->second;
}

}  // namespace ribbon_mapper::bench
