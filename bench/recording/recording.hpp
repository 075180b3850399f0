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

/// One scan line as the robot had it, and what only the truth knows.
struct RecordedLine {
  LaserBeams beams;
  LinePoses poses;                          ///< with the errors of the localisation
  Pose T_map_base_true = Pose::Identity();  ///< half way between the first and last beam
  Pose T_map_odom_true = Pose::Identity();  ///< at the same time: takes odom to the truth
  std::vector<std::int32_t> faces;  ///< index into Recording::face_normals, -1: none or unknown
};

/// A tour in memory: where it comes from, a simulator or a bag, is no matter to the benchmarks.
/// Without a truth (a bag) `faces`, `face_normals` and `truth` are empty, and the poses as recorded
/// stand for the true ones.
struct Recording {
  std::string name;
  double duration_s = 0.0;
  std::vector<RecordedLine> lines;
  std::vector<Eigen::Vector3d> face_normals;  ///< in map; zero: not planar
  std::vector<eval::Patch> truth;

  std::size_t beam_count() const;  ///< of all lines
};

/// Of each line, the number of beams that a preset takes for returns.
std::vector<std::size_t> returns_of(const Recording& recording, const ScanConfig& config);

/// How many times more often work on a short recording is repeated: medians of few lines waver.
int repetitions_factor(const Recording& recording);

/// The poses of all lines as they really were.
std::vector<StampedPose> true_trajectory(const Recording& recording);

/// The poses of a line with the true acquisition pose in the place of the believed one.
LinePoses with_true_pose(const RecordedLine& line);

/// The first `lines` of a recording.
Recording head_of(const Recording& recording, std::size_t lines);

}  // namespace ribbon_mapper::bench
