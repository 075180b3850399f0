// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/chain_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "test/modeler/registration/hall.hpp"

namespace ribbon_mapper {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The same equations as a ChainSystem and as one dense matrix.
class Equations {
 public:
  Equations(int poses, int landmarks)
      : system(poses, landmarks),
        matrix(MatrixXd::Zero(6 * poses + 3 * landmarks, 6 * poses + 3 * landmarks)),
        vector(VectorXd::Zero(6 * poses + 3 * landmarks)),
        poses_(poses) {
    for (int i = 0; i < poses; ++i) {
      const Matrix6 information = 100.0 * Matrix6::Identity() + hall::random_matrix(6, 6, ++seed_);
      add_pose(i, 0.5 * (information + information.transpose()));
    }
    for (int i = 0; i < landmarks; ++i) add_landmark(i);
  }

  void add_pose(int i, const Matrix6& information) {
    const Vector6 b = hall::random_matrix(6, 1, ++seed_);
    system.add_pose(i, information, b);
    matrix.block<6, 6>(6 * i, 6 * i) += information;
    vector.segment<6>(6 * i) += b;
  }
  void add_link(int i) {
    const Matrix6 block = hall::random_matrix(6, 6, ++seed_);
    system.add_link(i, block);
    matrix.block<6, 6>(6 * i, 6 * i + 6) += block;
    matrix.block<6, 6>(6 * i + 6, 6 * i) += block.transpose();
  }
  void add_landmark(int i) {
    const Eigen::Matrix3d information = 100.0 * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d b = hall::random_matrix(3, 1, ++seed_);
    system.add_landmark(i, information, b);
    matrix.block<3, 3>(row_of(i), row_of(i)) += information;
    vector.segment<3>(row_of(i)) += b;
  }
  void couple(int pose, int landmark) {
    const ChainSystem::Coupling block = hall::random_matrix(6, 3, ++seed_);
    system.add_coupling(pose, landmark, block);
    matrix.block<6, 3>(6 * pose, row_of(landmark)) += block;
    matrix.block<3, 6>(row_of(landmark), 6 * pose) += block.transpose();
  }

  /// Expects the solution to be that of the dense equations.
  void check() const {
    const VectorXd expected = matrix.ldlt().solve(vector);
    const ChainSystem::Solution solution = system.solve();
    ASSERT_EQ(solution.poses.size(), static_cast<std::size_t>(poses_));
    for (int i = 0; i < poses_; ++i) {
      EXPECT_LT((solution.poses[i] - expected.segment<6>(6 * i)).norm(), 1e-12) << "pose " << i;
    }
    for (std::size_t i = 0; i < solution.landmarks.size(); ++i) {
      EXPECT_LT((solution.landmarks[i] - expected.segment<3>(row_of(static_cast<int>(i)))).norm(),
                1e-12)
          << "landmark " << i;
    }
  }

  ChainSystem system;
  MatrixXd matrix;
  VectorXd vector;

 private:
  int row_of(int landmark) const { return 6 * poses_ + 3 * landmark; }

  int poses_;
  unsigned seed_ = 0;
};

TEST(ChainSystem, WithoutPosesSolvesForLandmarksAlone) { Equations(0, 2).check(); }

TEST(ChainSystem, SolvesForASinglePose) {
  Equations equations(1, 1);
  equations.couple(0, 0);
  equations.check();
}

TEST(ChainSystem, SolvesChainsOfAllLengths) {
  for (int poses = 2; poses <= 17; ++poses) {
    Equations equations(poses, 0);
    for (int i = 0; i + 1 < poses; ++i) equations.add_link(i);
    equations.check();
  }
}

TEST(ChainSystem, SolvesForLandmarksSeenOnceAlwaysNeverAndAgain) {
  constexpr int kPoses = 13;
  Equations equations(kPoses, 5);
  for (int i = 0; i + 1 < kPoses; ++i) equations.add_link(i);
  equations.couple(6, 0);
  for (int i = 0; i < kPoses; ++i) equations.couple(i, 1);
  for (const int pose : {0, 1, 11, 12}) equations.couple(pose, 3);  // and none sees landmark 2
  for (const int pose : {3, 4, 5}) equations.couple(pose, 4);
  equations.check();
}

TEST(ChainSystem, SolvesForSeparateChains) {
  Equations equations(9, 2);
  for (const int link : {0, 1, 2, 5, 6}) equations.add_link(link);  // 0..3, 4, 5..7 and 8
  for (int i = 0; i < 9; ++i) equations.couple(i, i % 2);
  equations.check();
}

TEST(ChainSystem, AddsUpBlocks) {
  Equations equations(3, 1);
  for (const int pose : {0, 2, 2, 0}) equations.couple(pose, 0);
  equations.add_link(1);
  equations.add_link(1);
  equations.add_landmark(0);
  equations.check();
}

}  // namespace
}  // namespace ribbon_mapper
