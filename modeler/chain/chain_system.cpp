// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/chain/chain_system.hpp"

#include "modeler/chain/chain_elimination.hpp"

namespace ribbon_mapper {

ChainSystem::ChainSystem(std::size_t poses, std::size_t landmarks)
    : poses_(poses), landmarks_(landmarks) {}

void ChainSystem::add_pose(std::size_t pose, const Matrix6& information, const Vector6& vector) {
  poses_[pose].information += information;
  poses_[pose].vector += vector;
}

void ChainSystem::add_landmark(std::size_t landmark, const Eigen::Matrix3d& information,
                               const Eigen::Vector3d& vector) {
  landmarks_[landmark].information += information;
  landmarks_[landmark].vector += vector;
}

void ChainSystem::add_coupling(std::size_t pose, std::uint32_t landmark, const Coupling& block) {
  auto& couplings = poses_[pose].couplings;
  for (auto& [number, sum] : couplings) {
    if (number == landmark) {
      sum += block;
      return;
    }
  }
  couplings.emplace_back(landmark, block);
}

ChainSystem::Solution ChainSystem::solve() const { return ChainElimination(*this).solution(); }

std::vector<Matrix6> ChainSystem::pose_covariances() const {
  return ChainElimination(*this).pose_covariances();
}

}  // namespace ribbon_mapper
