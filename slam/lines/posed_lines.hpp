// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "modeler/geometry/packed_poses.hpp"
#include "modeler/observations/observations.hpp"
#include "modeler/observations/posed_ribbon.hpp"
#include "modeler/registration/odometry_noise.hpp"
#include "modeler/registration/plane_observation.hpp"
#include "modeler/registration/pose_belief.hpp"
#include "slam/lines/odometry_source.hpp"

namespace ribbon_mapper::slam {

/// The lines of some observations with their estimated poses, in a frame called `start`: that of
/// the first line.
///
/// Besides the observations, a line takes 68 bytes, and 92 more with a source of the odometry.
class PosedLines {
 public:
  /// Starts without lines. `observations` must outlive this, and so must `odometry`, which takes
  /// the place of the recorded one unless it is null.
  explicit PosedLines(const Observations& observations, const OdometrySource* odometry = nullptr)
      : observations_(&observations), odometry_(odometry) {}

  /// Follows observations that were thinned since: forgets the lines that they have no longer. Must
  /// be called before lines are added. Returns true if they were thinned.
  bool keep_in_step();
  /// Returns true if the observations have a line that was not added yet.
  bool has_next() const { return stamps_.size() < observations_->trajectory().size(); }
  /// Adds the next line of the observations, at the origin of `start`.
  void add_next();
  /// Replaces the estimated pose of a line.
  void set_pose(std::size_t line, const Pose& T_start_base) {
    T_start_base_.set(line, T_start_base);
  }

  /// Declares whether the odometry's step to a line may be wrong by any amount in the plane: the
  /// wheels slipped, or the robot was pushed.
  void set_slip(std::uint32_t line, bool is_slip);
  /// Returns true if the odometry's step to a line was declared wrong.
  bool is_slip(std::uint32_t line) const { return slips_.count(line) > 0; }
  /// Returns how many steps in a row were declared wrong, the step to a line among them.
  std::uint32_t slip_length(std::uint32_t line) const;

  /// Returns the covariance of a step by what the source alone has measured, see
  /// OdometrySource::step_covariance(). There is a source.
  Eigen::Matrix3d source_covariance(std::size_t line) const {
    return source_covariances_[line].cast<double>();
  }

  /// Returns the number of lines.
  std::uint32_t size() const { return static_cast<std::uint32_t>(stamps_.size()); }
  /// Returns the stamp of a line.
  Time stamp(std::size_t line) const { return stamps_[line]; }
  /// Returns the time from one line to another [s].
  double seconds_between(std::size_t from, std::size_t to) const {
    return to_seconds(stamps_[to] - stamps_[from]);
  }
  /// Returns the estimated pose of a line.
  Pose T_start_base(std::size_t line) const { return T_start_base_[line]; }
  /// Returns the pose of a line by odometry.
  Pose T_odom_base(std::size_t line) const {
    return odometry_ != nullptr ? T_odom_base_[line] : recorded_T_odom_base(line);
  }
  /// Returns the motion of the base by odometry from the line before; none at the first line.
  Pose step(std::size_t line) const;
  /// Returns the same as it was recorded, whatever the source of the odometry.
  Pose recorded_step(std::size_t line) const;
  /// Returns true if a source takes the place of the recorded odometry.
  bool has_source() const { return odometry_ != nullptr; }
  /// Returns the covariance of the error of step(), along the axes of the base before it, if there
  /// is a source: that of the recorded odometry, whose noise is given, fused with the source's.
  Matrix6 fused_covariance(std::size_t line, const OdometryNoise& noise) const;
  /// Returns the belief of a line's pose from that of the line before. `noise` is that of the
  /// recorded odometry.
  PoseBelief after_step_to(std::size_t line, const PoseBelief& before,
                           const OdometryNoise& noise) const;

  /// Returns the index of a line's first ribbon; that of size() is the number of ribbons.
  std::uint32_t first_ribbon(std::size_t line) const { return first_ribbons_[line]; }
  /// Returns a ribbon.
  const Ribbon& ribbon(std::size_t index) const { return observations_->ribbons()[index]; }
  /// Returns a ribbon at the estimated pose of its line.
  PosedRibbon posed_ribbon(std::size_t index) const {
    return {ribbon(index), T_start_base(ribbon(index).pose)};
  }
  /// Returns the laser's position at a line, in start [m].
  Eigen::Vector3d sensor(std::size_t line) const {
    return T_start_base(line) * observations_->unassigned()[line].sensor.cast<double>();
  }
  /// Returns what the ribbons of a line measure, in their order.
  std::vector<PlaneObservation> measured(std::size_t line, const OdometryNoise& noise,
                                         const RangeNoise& ranges) const;

 private:
  Pose recorded_T_odom_base(std::size_t line) const {
    return observations_->trajectory().recorded().T_odom_base()[line];
  }
  void keep_steps(const std::vector<std::uint32_t>& kept);
  Eigen::Matrix3f covariance_between(std::uint32_t from, std::uint32_t to) const;
  std::uint32_t end_of_line(std::uint32_t line) const;

  const Observations* observations_;
  const OdometrySource* odometry_;
  std::vector<Time> stamps_;
  PackedPoses T_start_base_;
  PackedPoses T_odom_base_;                          // of the source, if there is one
  std::vector<Eigen::Matrix3f> source_covariances_;  // of the steps by the source alone
  std::vector<std::uint32_t> first_ribbons_{0};      // of each line, and their number
  std::size_t ribbons_seen_ = 0;
  std::set<std::uint32_t> slips_;  // lines
};

}  // namespace ribbon_mapper::slam
