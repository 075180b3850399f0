// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/model_file/trajectory_section.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modeler/geometry/pose_defect.hpp"
#include "modeler/model_file/pose_matrix.hpp"

namespace ribbon_mapper {
namespace {

using Numbers = PackedPoses::Numbers;

constexpr std::size_t kPoseBytes = sizeof(Numbers);
/// Largest coordinate. A correction may move a pose beyond what lines may have.
constexpr double kLargest_m = 10.0 * kMaxCoordinate_m;

Numbers read_pose(ByteReader& from) {
  const auto n = from.numbers<Numbers>();
  const double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2] + n[3] * n[3];
  const bool is_near = std::all_of(n.begin() + 4, n.end(),
                                   [](double value) { return std::abs(value) <= kLargest_m; });
  if (!(std::abs(square - 1.0) < 1e-6) || !is_near) from.fail("has a pose that cannot be");
  return n;
}

void write_poses(const TrackedPoses& poses, ByteWriter& to) {
  to.integer(std::uint64_t{poses.size()});
  for (std::size_t i = 0; i < poses.size(); ++i) {
    to.integer(std::int64_t{poses.stamps()[i].count()});
    to.numbers(poses.T_map_base().numbers(i));
    to.numbers(poses.T_odom_base().numbers(i));
  }
}

TrackedPoses read_poses(ByteReader& from) {
  TrackedPoses poses;
  const std::size_t count = from.count(sizeof(std::int64_t) + 2 * kPoseBytes);
  poses.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Time stamp(from.integer<std::int64_t>());
    if (i > 0 && stamp <= poses.stamps().back()) from.fail("has stamps that do not increase");
    const Numbers T_map_base = read_pose(from);
    poses.push_back(stamp, T_map_base, read_pose(from));
  }
  return poses;
}

/// Reads the change of a correction, which may move far away.
Pose read_change(ByteReader& from) {
  Pose change = read_matrix(from);
  Pose rotation = Pose::Identity();
  rotation.linear() = change.linear();
  if (find_defect(rotation) || !(change.translation().norm() < kLargest_m)) {
    from.fail("has a correction that cannot be");
  }
  return change;
}

}  // namespace

void write_trajectory(const Trajectory& trajectory, ByteWriter& to) {
  write_poses(trajectory.recorded(), to);
  to.integer(static_cast<std::uint8_t>(trajectory.is_corrected()));
  if (!trajectory.is_corrected()) return;
  to.integer(static_cast<std::uint8_t>(trajectory.is_as_corrected()));
  for (std::size_t i = 0; i < trajectory.size(); ++i) to.numbers(trajectory.poses_now().numbers(i));
  const Correction::Parts& correction = trajectory.correction()->parts();
  write_poses(correction.poses, to);
  write_matrix(correction.first_change, to);
  write_matrix(correction.last_change, to);
}

Trajectory::Parts read_trajectory(ByteReader& from) {
  Trajectory::Parts parts;
  parts.recorded = read_poses(from);
  if (!from.flag()) return parts;
  parts.is_as_corrected = from.flag();
  for (std::size_t i = 0; i < parts.recorded.size(); ++i) parts.now.push_back(read_pose(from));
  Correction::Parts correction;
  correction.poses = read_poses(from);
  if (parts.recorded.empty() || correction.poses.empty()) from.fail("has a correction of nothing");
  correction.first_change = read_change(from);
  correction.last_change = read_change(from);
  parts.correction.emplace(std::move(correction));
  return parts;
}

}  // namespace ribbon_mapper
