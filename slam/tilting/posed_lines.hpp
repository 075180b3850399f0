// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/geometry/packed_poses.hpp"
#include "modeler/observations/posed_ribbon.hpp"
#include "modeler/registration/odometry_noise.hpp"
#include "modeler/registration/plane_observation.hpp"

namespace ribbon_mapper::slam {

/// Lines with their ribbons, their poses by odometry and their estimated poses. The frame of the
/// estimate is called `start`: the pose of the first line.
class PosedLines {
 public:
  /// Refers to ribbons in the order of their lines, which must outlive this.
  explicit PosedLines(const std::vector<Ribbon>& ribbons) : ribbons_(&ribbons) {}

  /// Appends a line whose ribbons are those from the last line's on.
  void add(Time stamp, const Pose& T_odom_base, const Pose& T_start_base);
  /// Replaces the estimated pose of a line.
  void set_pose(std::size_t line, const Pose& T_start_base) { T_start_base_.set(line, T_start_base); }

  /// Returns the number of lines.
  std::uint32_t size() const { return static_cast<std::uint32_t>(stamps_.size()); }
  /// Returns the stamp of a line.
  Time stamp(std::size_t line) const { return stamps_[line]; }
  /// Returns the estimated pose of a line.
  Pose pose(std::size_t line) const { return T_start_base_[line]; }
  /// Returns the motion of the base by odometry from the line before to this one; none at the first.
  Pose step(std::size_t line) const;

  /// Returns the index of a line's first ribbon; size() gives the number of ribbons.
  std::uint32_t first_ribbon(std::size_t line) const { return first_ribbons_[line]; }
  /// Returns the number of ribbons of the lines before `line`.
  std::uint32_t ribbon_count(std::size_t line) const { return first_ribbons_[line]; }
  /// Returns a ribbon.
  const Ribbon& ribbon(std::size_t index) const { return (*ribbons_)[index]; }
  /// Returns a ribbon at the estimated pose of its line.
  PosedRibbon posed_ribbon(std::size_t index) const {
    return {ribbon(index), pose(ribbon(index).pose)};
  }
  /// Returns what the ribbons of a line measure, in their order.
  std::vector<PlaneObservation> observations(std::size_t line, const OdometryNoise& noise,
                                             const RangeNoise& ranges) const;

 private:
  const std::vector<Ribbon>* ribbons_;
  std::vector<Time> stamps_;
  PackedPoses T_odom_base_, T_start_base_;
  std::vector<std::uint32_t> first_ribbons_{0};  // of each line, and the end
};

}  // namespace ribbon_mapper::slam
