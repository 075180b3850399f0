// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/geometry/compact_moments.hpp"

#include <algorithm>

namespace ribbon_mapper {

CompactMoments::CompactMoments(const Moments& moments)
    : weight_(static_cast<float>(moments.weight())), mean_(moments.mean().cast<float>()) {
  const Eigen::Matrix3f c = moments.covariance().cast<float>();
  covariance_ = {c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2)};
}

CompactMoments CompactMoments::of(const Numbers& numbers) {
  CompactMoments moments;
  moments.weight_ = numbers[0];
  moments.mean_ = {numbers[1], numbers[2], numbers[3]};
  std::copy(numbers.begin() + 4, numbers.end(), moments.covariance_.begin());
  return moments;
}

CompactMoments::Numbers CompactMoments::numbers() const {
  Numbers numbers{weight_, mean_.x(), mean_.y(), mean_.z()};
  std::copy(covariance_.begin(), covariance_.end(), numbers.begin() + 4);
  return numbers;
}

Eigen::Matrix3d CompactMoments::covariance() const {
  const auto& c = covariance_;
  Eigen::Matrix3d full;
  full << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
  return full;
}

Moments CompactMoments::transformed(const Pose& T) const {
  const Eigen::Matrix3d R = T.linear();
  return Moments::of(weight_, T * mean(), R * covariance() * R.transpose());
}

}  // namespace ribbon_mapper
