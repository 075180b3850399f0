// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/geometry/packed_poses.hpp"

#include <algorithm>
#include <cstring>

#include "modeler/geometry/vector_storage.hpp"

namespace ribbon_mapper {
namespace {

/// Returns whether all numbers have the same bits. Unlike ==, tells -0 from 0.
bool have_same_bits(const PackedPoses::Numbers& a, const PackedPoses::Numbers& b) {
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): it is what is meant
  return std::memcmp(a.data(), b.data(), sizeof a) == 0;
}

}  // namespace

PackedPoses::Numbers PackedPoses::packed(const Pose& pose) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(pose.linear()).normalized();
  const Eigen::Vector3d t = pose.translation();
  return {q.x(), q.y(), q.z(), q.w(), t.x(), t.y(), t.z()};
}

void PackedPoses::reserve_one_more() { ribbon_mapper::reserve_one_more(poses_); }

void PackedPoses::push_back(const Pose& pose) {
  reserve_one_more();
  poses_.push_back(packed(pose));
}

void PackedPoses::append_first(std::size_t count, const PackedPoses& others) {
  const auto first = others.poses_.begin();
  poses_.insert(poses_.end(), first, first + static_cast<std::ptrdiff_t>(count));
}

bool PackedPoses::holds(std::size_t index, const Pose& pose) const {
  const Numbers other = packed(pose);
  return have_same_bits(poses_[index], other);
}

std::size_t PackedPoses::common_with(const PackedPoses& others) const {
  const std::size_t count = std::min(size(), others.size());
  std::size_t i = 0;
  while (i < count && have_same_bits(poses_[i], others.poses_[i])) ++i;
  return i;
}

void PackedPoses::keep(const std::vector<std::uint32_t>& indices) { keep_indices(indices, poses_); }

Pose PackedPoses::operator[](std::size_t index) const {
  const Numbers& p = poses_[index];
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond(p[3], p[0], p[1], p[2]).toRotationMatrix();
  pose.translation() << p[4], p[5], p[6];
  return pose;
}

}  // namespace ribbon_mapper
