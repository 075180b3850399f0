// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/chain_system.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>

namespace ribbon_mapper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// An unknown: the pose or the landmark of this number.
struct Unknown {
  bool is_landmark;
  std::uint32_t number;
  Index size() const { return is_landmark ? 3 : 6; }
};

Index size_of(const std::vector<Unknown>& unknowns) {
  Index size = 0;
  for (const Unknown& unknown : unknowns) size += unknown.size();
  return size;
}

/// A part of the equations: `eliminated` unknowns come first, then those that remain.
struct Front {
  std::vector<Unknown> unknowns;
  std::vector<Index> offsets;
  MatrixXd matrix;
  VectorXd vector;
};

/// What is left to do once the remaining unknowns of a front are known.
struct Elimination {
  std::vector<Unknown> eliminated, remaining;
  MatrixXd coupling;  // factor^-1 * (block between eliminated and remaining)
  VectorXd vector;    // factor^-1 * right-hand side
};

struct Range {
  std::uint32_t first, end;
  std::uint32_t middle() const { return first + (end - first) / 2; }
  bool is_empty() const { return first >= end; }
};

}  // namespace

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

/// Eliminates the unknowns of a system in the order of a balanced tree.
class ChainElimination {
 public:
  explicit ChainElimination(const ChainSystem& system);
  ChainSystem::Solution solution() const;

 private:
  std::uint32_t pose_count() const { return static_cast<std::uint32_t>(system_.poses_.size()); }
  Front eliminate(const Range& range);
  std::vector<Unknown> unknowns_of(const Range& range, const std::vector<const Front*>& children,
                                   std::size_t& eliminated);
  void add_own_equations(const Range& range, Front& front, std::size_t eliminated);
  void extend_add(const Front& child, Front& front);
  Front reduced(const Front& front, std::size_t eliminated);
  void index(const Front& front);
  Index& offset_of(const Unknown& unknown) {
    return unknown.is_landmark ? landmark_offsets_[unknown.number] : pose_offsets_[unknown.number];
  }

  const ChainSystem& system_;
  std::vector<Range> observed_;            // by landmark: from the first to the last pose
  std::vector<Index> pose_offsets_;        // in the front that was indexed last
  std::vector<Index> landmark_offsets_;    // the same
  std::vector<Elimination> eliminations_;  // children before parents
  std::vector<std::uint32_t> marks_;       // by landmark: last front that listed it
  std::uint32_t mark_ = 0;
};

ChainElimination::ChainElimination(const ChainSystem& system)
    : system_(system),
      observed_(system.landmarks(), {std::numeric_limits<std::uint32_t>::max(), 0}),
      pose_offsets_(system.poses(), -1),
      landmark_offsets_(system.landmarks(), -1),
      marks_(system.landmarks(), 0) {
  for (std::uint32_t pose = 0; pose < pose_count(); ++pose) {
    for (const auto& [landmark, block] : system.poses_[pose].couplings) {
      Range& range = observed_[landmark];
      range.first = std::min(range.first, pose);
      range.end = std::max(range.end, pose + 1);
    }
  }
  eliminations_.reserve(system.poses());
  if (pose_count() > 0) eliminate({0, pose_count()});
}

std::vector<Unknown> ChainElimination::unknowns_of(const Range& range,
                                                   const std::vector<const Front*>& children,
                                                   std::size_t& eliminated) {
  const std::uint32_t middle = range.middle();
  std::vector<Unknown> first{{false, middle}}, rest;
  if (range.first > 0) rest.push_back({false, range.first - 1});
  if (range.end < pose_count()) rest.push_back({false, range.end});
  ++mark_;
  const auto list = [&](std::uint32_t landmark) {
    if (marks_[landmark] == mark_) return;
    marks_[landmark] = mark_;
    const Range& seen = observed_[landmark];
    const bool is_complete = range.first <= seen.first && seen.end <= range.end;
    (is_complete ? first : rest).push_back({true, landmark});
  };
  for (const auto& [landmark, block] : system_.poses_[middle].couplings) list(landmark);
  for (const Front* child : children) {
    for (const Unknown& unknown : child->unknowns) {
      if (unknown.is_landmark) list(unknown.number);
    }
  }
  eliminated = first.size();
  first.insert(first.end(), rest.begin(), rest.end());
  return first;
}

void ChainElimination::index(const Front& front) {
  for (std::size_t i = 0; i < front.unknowns.size(); ++i) {
    offset_of(front.unknowns[i]) = front.offsets[i];
  }
}

void ChainElimination::add_own_equations(const Range& range, Front& front, std::size_t eliminated) {
  const std::uint32_t middle = range.middle();
  const ChainSystem::PoseEquations& own = system_.poses_[middle];
  front.matrix.block<6, 6>(0, 0) += own.information;
  front.vector.head<6>() += own.vector;
  const auto link = [&](std::uint32_t pose, const Matrix6& block) {  // from `middle` to `pose`
    const Index at = pose_offsets_[pose];
    front.matrix.block<6, 6>(0, at) += block;
    front.matrix.block<6, 6>(at, 0) += block.transpose();
  };
  // Links to poses within the range belong to the child that eliminates these.
  if (middle == range.first && middle > 0) {
    link(middle - 1, system_.poses_[middle - 1].to_next.transpose());
  }
  if (middle + 1 == range.end && range.end < pose_count()) link(middle + 1, own.to_next);
  for (const auto& [landmark, block] : own.couplings) {
    const Index at = landmark_offsets_[landmark];
    front.matrix.block<6, 3>(0, at) += block;
    front.matrix.block<3, 6>(at, 0) += block.transpose();
  }
  for (std::size_t i = 1; i < eliminated; ++i) {
    const auto& landmark = system_.landmarks_[front.unknowns[i].number];
    front.matrix.block<3, 3>(front.offsets[i], front.offsets[i]) += landmark.information;
    front.vector.segment<3>(front.offsets[i]) += landmark.vector;
  }
}

void ChainElimination::extend_add(const Front& child, Front& front) {
  for (std::size_t i = 0; i < child.unknowns.size(); ++i) {
    const Index to = offset_of(child.unknowns[i]), from = child.offsets[i];
    const Index size = child.unknowns[i].size();
    front.vector.segment(to, size) += child.vector.segment(from, size);
    for (std::size_t k = 0; k < child.unknowns.size(); ++k) {
      front.matrix.block(offset_of(child.unknowns[k]), to, child.unknowns[k].size(), size) +=
          child.matrix.block(child.offsets[k], from, child.unknowns[k].size(), size);
    }
  }
}

/// Eliminates the first unknowns of a front, and returns the equations of the others.
Front ChainElimination::reduced(const Front& front, std::size_t eliminated) {
  const auto split = front.unknowns.begin() + static_cast<std::ptrdiff_t>(eliminated);
  Elimination step;
  step.eliminated.assign(front.unknowns.begin(), split);
  step.remaining.assign(split, front.unknowns.end());
  const Index e = size_of(step.eliminated), r = front.matrix.rows() - e;
  const Eigen::LLT<MatrixXd> factor(front.matrix.topLeftCorner(e, e));
  step.coupling = factor.solve(front.matrix.topRightCorner(e, r));
  step.vector = factor.solve(front.vector.head(e));
  Front rest;
  rest.unknowns = step.remaining;
  rest.matrix = front.matrix.bottomRightCorner(r, r);
  rest.matrix.noalias() -= front.matrix.bottomLeftCorner(r, e) * step.coupling;
  rest.vector = front.vector.tail(r) - front.matrix.bottomLeftCorner(r, e) * step.vector;
  for (std::size_t i = eliminated; i < front.offsets.size(); ++i) {
    rest.offsets.push_back(front.offsets[i] - e);
  }
  eliminations_.push_back(std::move(step));
  return rest;
}

/// Eliminates all poses of a range, and returns the equations of what remains.
Front ChainElimination::eliminate(const Range& range) {
  const std::uint32_t middle = range.middle();
  const Range before{range.first, middle}, behind{middle + 1, range.end};
  std::vector<Front> children;
  if (!before.is_empty()) children.push_back(eliminate(before));
  if (!behind.is_empty()) children.push_back(eliminate(behind));
  std::vector<const Front*> pointers;
  for (const Front& child : children) pointers.push_back(&child);
  Front front;
  std::size_t eliminated = 0;
  front.unknowns = unknowns_of(range, pointers, eliminated);
  Index size = 0;
  for (const Unknown& unknown : front.unknowns) {
    front.offsets.push_back(size);
    size += unknown.size();
  }
  front.matrix = MatrixXd::Zero(size, size);
  front.vector = VectorXd::Zero(size);
  index(front);
  add_own_equations(range, front, eliminated);
  for (const Front& child : children) extend_add(child, front);
  return reduced(front, eliminated);
}

ChainSystem::Solution ChainElimination::solution() const {
  ChainSystem::Solution solution{
      std::vector<Vector6>(system_.poses(), Vector6::Zero()),
      std::vector<Eigen::Vector3d>(system_.landmarks(), Eigen::Vector3d::Zero())};
  for (std::size_t i = 0; i < system_.landmarks(); ++i) {
    const ChainSystem::LandmarkEquations& alone = system_.landmarks_[i];
    if (observed_[i].is_empty())
      solution.landmarks[i] = alone.information.llt().solve(alone.vector);
  }
  VectorXd rest;
  for (auto step = eliminations_.rbegin(); step != eliminations_.rend(); ++step) {
    rest.resize(step->coupling.cols());
    Index at = 0;
    for (const Unknown& unknown : step->remaining) {
      if (unknown.is_landmark)
        rest.segment<3>(at) = solution.landmarks[unknown.number];
      else
        rest.segment<6>(at) = solution.poses[unknown.number];
      at += unknown.size();
    }
    const VectorXd values = step->vector - step->coupling * rest;
    at = 0;
    for (const Unknown& unknown : step->eliminated) {
      if (unknown.is_landmark)
        solution.landmarks[unknown.number] = values.segment<3>(at);
      else
        solution.poses[unknown.number] = values.segment<6>(at);
      at += unknown.size();
    }
  }
  return solution;
}

ChainSystem::Solution ChainSystem::solve() const { return ChainElimination(*this).solution(); }

}  // namespace ribbon_mapper
