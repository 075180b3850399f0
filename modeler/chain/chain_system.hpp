// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "modeler/chain/matrix6.hpp"

namespace ribbon_mapper {

/// The normal equations of a chain of poses and the landmarks that are observed from them: six
/// unknowns a pose, three a landmark.
///
/// Poses are linked to the next one only. They are eliminated in the order of a balanced tree over
/// the chain (nested dissection, George 1973), and a landmark as soon as the subtree that observes
/// it is complete. A chain that observes each landmark from one place takes linear time.
class ChainSystem {
 public:
  /// The couplings of one pose with landmarks.
  using Coupling = Eigen::Matrix<double, 6, 3>;

  /// The errors that solve the equations.
  struct Solution {
    std::vector<Vector6> poses;              ///< by pose
    std::vector<Eigen::Vector3d> landmarks;  ///< by landmark
  };

  /// Creates equations without information.
  ChainSystem(std::size_t poses, std::size_t landmarks);

  /// Returns the number of poses.
  std::size_t poses() const { return poses_.size(); }
  /// Returns the number of landmarks.
  std::size_t landmarks() const { return landmarks_.size(); }

  /// Adds information on a pose: a block of the diagonal and of the right-hand side.
  void add_pose(std::size_t pose, const Matrix6& information, const Vector6& vector);
  /// Adds the block of the matrix between a pose and the next one.
  void add_link(std::size_t pose, const Matrix6& block) { poses_[pose].to_next += block; }
  /// Adds information on a landmark.
  void add_landmark(std::size_t landmark, const Eigen::Matrix3d& information,
                    const Eigen::Vector3d& vector);
  /// Adds the block of the matrix between a pose and a landmark.
  void add_coupling(std::size_t pose, std::uint32_t landmark, const Coupling& block);

  /// Returns the solution. The matrix must be positive definite.
  Solution solve() const;

  /// Returns the blocks of the inverse matrix on its diagonal, by pose: the covariances of their
  /// errors. Only those blocks of the inverse are computed that lead to them (Takahashi et al.,
  /// 'Formation of a sparse bus impedance matrix', 1973), in about twice the time of solve(). The
  /// matrix must be positive definite.
  std::vector<Matrix6> pose_covariances() const;

 private:
  friend class ChainElimination;
  struct PoseEquations {
    Matrix6 information = Matrix6::Zero(), to_next = Matrix6::Zero();
    Vector6 vector = Vector6::Zero();
    std::vector<std::pair<std::uint32_t, Coupling>> couplings;  // by landmark
  };
  struct LandmarkEquations {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  };

  std::vector<PoseEquations> poses_;
  std::vector<LandmarkEquations> landmarks_;
};

}  // namespace ribbon_mapper
