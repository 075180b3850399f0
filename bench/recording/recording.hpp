// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "eval/metrics/patch.hpp"
#include "modeler/geometry/pose.hpp"
#include "modeler/scan/laser_beams.hpp"
#include "modeler/scan/scan_config.hpp"

namespace ribbon_mapper::bench {

/// A scan line with the robot's poses and with the ground truth.
struct RecordedLine {
  LaserBeams beams;                         ///< the ranges
  LinePoses poses;                          ///< noisy poses
  Pose T_map_base_true = Pose::Identity();  ///< true pose at the middle of the line
  Pose T_map_odom_true = Pose::Identity();  ///< true odom frame at the same time
  std::vector<std::int32_t> faces;          ///< by beam: index into Recording::face_normals, or -1
};

/// A tour in memory, from the simulator or from a bag. For a bag there is no ground truth: `faces`,
/// `face_normals` and `truth` are empty, and true poses are the recorded ones.
struct Recording {
  std::string name;                           ///< for the report
  double duration_s = 0.0;                    ///< length of the tour
  std::vector<RecordedLine> lines;            ///< by time
  std::vector<Eigen::Vector3d> face_normals;  ///< in map; zero for curved faces
  std::vector<eval::Patch> truth;             ///< the true planes

  /// Returns the number of beams of all lines.
  std::size_t beam_count() const;
};

/// Returns the number of valid beams of each line under a preset.
std::vector<std::size_t> returns_of(const Recording& recording, const ScanConfig& config);

/// Returns the factor for repetitions on a recording. Short recordings need more repetitions for
/// stable medians.
int repetitions_factor(const Recording& recording);

/// Returns the true poses of all lines.
std::vector<StampedPose> true_trajectory(const Recording& recording);

/// Returns the poses of a line with the true instead of the noisy acquisition pose.
LinePoses with_true_pose(const RecordedLine& line);

/// Returns the first `lines` lines of a recording.
Recording head_of(const Recording& recording, std::size_t lines);

}  // namespace ribbon_mapper::bench
