// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/geometry/pose_defect.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kTolerance = 1e-6;

bool is_rotation(const Eigen::Matrix3d& matrix) {
  const Eigen::Matrix3d deviation = matrix.transpose() * matrix - Eigen::Matrix3d::Identity();
  return matrix.determinant() > 0.0 && deviation.norm() < kTolerance;
}

}  // namespace

std::optional<std::string> find_defect(const Pose& pose) {
  if (!pose.matrix().allFinite()) return "is not finite";
  if (!is_rotation(pose.linear())) return "is not rigid";
  if (pose.translation().cwiseAbs().maxCoeff() > kMaxCoordinate_m) {
    return "lies more than 1e9 m from the origin";
  }
  return std::nullopt;
}

}  // namespace ribbon_mapper
