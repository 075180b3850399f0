// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/chain/chain_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

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

  /// Adds the normal equations of a step from a pose to the next.
  void add_step(int i) {
    const Matrix6 by_from = hall::random_matrix(6, 6, ++seed_);
    add_information(i, by_from.transpose() * by_from);
    add_information(i + 1, Matrix6::Identity());
    system.add_link(i, by_from.transpose());
    matrix.block<6, 6>(6 * i, 6 * i + 6) += by_from.transpose();
    matrix.block<6, 6>(6 * i + 6, 6 * i) += by_from;
  }
  /// Adds the normal equations of an observation with derivatives by pose and landmark.
  void add_observation(int pose, int landmark, const MatrixXd& derivative) {
    const MatrixXd all = 1e3 * derivative.transpose() * derivative;
    const int row = row_of(landmark);
    add_information(pose, all.topLeftCorner<6, 6>());
    system.add_landmark(landmark, all.bottomRightCorner<3, 3>(), Eigen::Vector3d::Zero());
    system.add_coupling(pose, landmark, all.topRightCorner<6, 3>());
    matrix.block<3, 3>(row, row) += all.bottomRightCorner<3, 3>();
    matrix.block<6, 3>(6 * pose, row) += all.topRightCorner<6, 3>();
    matrix.block<3, 6>(row, 6 * pose) += all.bottomLeftCorner<3, 6>();
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

  /// Expects the covariances to be those of the dense inverse.
  void check_covariances() const {
    const MatrixXd inverse = matrix.llt().solve(MatrixXd::Identity(matrix.rows(), matrix.cols()));
    const std::vector<Matrix6> covariances = system.pose_covariances();
    ASSERT_EQ(covariances.size(), static_cast<std::size_t>(poses_));
    for (int i = 0; i < poses_; ++i) {
      const Matrix6 expected = inverse.block<6, 6>(6 * i, 6 * i);
      EXPECT_LT((covariances[i] - expected).norm(), 1e-9 * expected.norm()) << "pose " << i;
      EXPECT_EQ(covariances[i], covariances[i].transpose()) << "pose " << i;
    }
  }

  ChainSystem system;
  MatrixXd matrix;
  VectorXd vector;

 private:
  void add_information(int pose, const Matrix6& information) {
    system.add_pose(pose, information, Vector6::Zero());
    matrix.block<6, 6>(6 * pose, 6 * pose) += information;
  }
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

/// A chain whose poses see random landmarks near them, and some far away: the normal equations of
/// random observations, so that unknowns are correlated along the whole chain. No pose sees the
/// last landmark.
Equations random_equations(int poses, int landmarks, unsigned seed) {
  Equations equations(poses, landmarks);
  std::mt19937 random(seed);
  std::bernoulli_distribution is_seen(0.3), is_far(0.05);
  const auto observe = [&](int pose, int landmark, unsigned number) {
    equations.add_observation(pose, landmark, hall::random_matrix(2, 9, 1000 * seed + number));
  };
  unsigned number = 0;
  for (int i = 0; i < poses; ++i) {
    if (i + 1 < poses && i % 11 != 10) equations.add_step(i);
    for (int k = 0; k + 1 < landmarks; ++k) {
      const bool is_near = std::abs(i * landmarks - k * poses) < 3 * poses;
      if (is_near ? is_seen(random) : is_far(random)) observe(i, k, ++number);
    }
  }
  return equations;
}

TEST(ChainSystem, CovariancesAreBlocksOfTheDenseInverse) {
  for (const int poses : {1, 2, 3, 17, 64}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE(testing::Message() << poses << " poses, seed " << seed);
      random_equations(poses, 1 + poses / 2, seed).check_covariances();
      random_equations(poses, 0, seed).check_covariances();
    }
  }
}

TEST(ChainSystem, WithoutPosesHasNoCovariances) {
  EXPECT_TRUE(ChainSystem(0, 3).pose_covariances().empty());
}

TEST(ChainSystem, CovarianceGrowsFromAPoseThatIsKnown) {
  constexpr int kPoses = 40;
  ChainSystem chain(kPoses, 0);
  chain.add_pose(0, Matrix6::Identity(), Vector6::Zero());
  for (std::size_t i = 0; i + 1 < kPoses; ++i) {  // steps of unit variance
    chain.add_pose(i, Matrix6::Identity(), Vector6::Zero());
    chain.add_pose(i + 1, Matrix6::Identity(), Vector6::Zero());
    chain.add_link(i, -Matrix6::Identity());
  }
  const std::vector<Matrix6> covariances = chain.pose_covariances();
  for (std::size_t i = 0; i < kPoses; ++i) {
    EXPECT_TRUE(covariances[i].isApprox((1.0 + static_cast<double>(i)) * Matrix6::Identity(), 1e-9))
        << "pose " << i;
  }
}

}  // namespace
}  // namespace ribbon_mapper
