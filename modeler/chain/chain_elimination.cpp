// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/chain/chain_elimination.hpp"

#include <algorithm>
#include <limits>

namespace ribbon_mapper {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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

std::vector<ChainElimination::Unknown> ChainElimination::unknowns_of(
    const Range& range, const std::vector<Front>& children, std::size_t& eliminated) {
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
  for (const Front& child : children) {
    for (const Unknown& unknown : child.unknowns) {
      if (unknown.is_landmark) list(unknown.number);
    }
  }
  eliminated = first.size();
  first.insert(first.end(), rest.begin(), rest.end());
  return first;
}

Index ChainElimination::size_of(const std::vector<Unknown>& unknowns) {
  Index size = 0;
  for (const Unknown& unknown : unknowns) size += unknown.size();
  return size;
}

void ChainElimination::list_offsets(Block& block) {
  Index size = 0;
  for (const Unknown& unknown : block.unknowns) {
    block.offsets.push_back(size);
    size += unknown.size();
  }
}

void ChainElimination::index(const Block& block) {
  for (std::size_t i = 0; i < block.unknowns.size(); ++i) {
    offset_of(block.unknowns[i]) = block.offsets[i];
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
ChainElimination::Front ChainElimination::reduced(const Front& front, std::size_t eliminated) {
  const auto split = front.unknowns.begin() + static_cast<std::ptrdiff_t>(eliminated);
  Elimination step;
  step.eliminated.assign(front.unknowns.begin(), split);
  step.remaining.assign(split, front.unknowns.end());
  const Index e = size_of(step.eliminated), r = front.matrix.rows() - e;
  step.factor.compute(front.matrix.topLeftCorner(e, e));
  // Eigen's solver may not be given a matrix without columns.
  step.coupling.resize(e, r);
  if (r > 0) step.coupling = step.factor.solve(front.matrix.topRightCorner(e, r));
  step.vector = step.factor.solve(front.vector.head(e));
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
ChainElimination::Front ChainElimination::eliminate(const Range& range) {
  std::vector<Front> children;
  for (const Range& part : {range.before(), range.behind()}) {
    if (!part.is_empty()) children.push_back(eliminate(part));
  }
  Front front;
  std::size_t eliminated = 0;
  front.unknowns = unknowns_of(range, children, eliminated);
  list_offsets(front);
  const Index size = size_of(front.unknowns);
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

/// Returns the block of some unknowns, all of which `above` has.
MatrixXd ChainElimination::part_of(const Block& above, const std::vector<Unknown>& unknowns) {
  index(above);
  const Index size = size_of(unknowns);
  MatrixXd part(size, size);
  Index column = 0;
  for (const Unknown& of_column : unknowns) {
    Index row = 0;
    for (const Unknown& of_row : unknowns) {
      part.block(row, column, of_row.size(), of_column.size()) = above.matrix.block(
          offset_of(of_row), offset_of(of_column), of_row.size(), of_column.size());
      row += of_row.size();
    }
    column += of_column.size();
  }
  return part;
}

/// Adds the covariances of a range's poses. `above` holds those of what remains of its front, and
/// `first_step` is the range's first elimination.
void ChainElimination::add_covariances(const Range& range, std::size_t first_step,
                                       const Block& above, std::vector<Matrix6>& covariances) {
  const Elimination& step = eliminations_[first_step + range.size() - 1];
  const bool is_leaf = range.size() == 1;  // only the pose's own block is asked for
  const Index e = step.coupling.rows(), r = step.coupling.cols(), rows = is_leaf ? 6 : e;
  const MatrixXd remaining = part_of(above, step.remaining);
  const MatrixXd mixed = step.coupling.topRows(rows) * remaining;  // negative
  MatrixXd own = step.factor.solve(MatrixXd::Identity(e, rows)).topRows(rows);
  own.noalias() += mixed * step.coupling.topRows(rows).transpose();
  covariances[range.middle()] =
      0.5 * (own.topLeftCorner<6, 6>() + own.topLeftCorner<6, 6>().transpose());
  if (is_leaf) return;
  Block here;
  here.unknowns = step.eliminated;
  here.unknowns.insert(here.unknowns.end(), step.remaining.begin(), step.remaining.end());
  list_offsets(here);
  here.matrix.resize(e + r, e + r);
  here.matrix << own, -mixed, -mixed.transpose(), remaining;
  const Range before = range.before(), behind = range.behind();
  if (!before.is_empty()) add_covariances(before, first_step, here, covariances);
  if (!behind.is_empty()) add_covariances(behind, first_step + before.size(), here, covariances);
}

std::vector<Matrix6> ChainElimination::pose_covariances() {
  std::vector<Matrix6> covariances(system_.poses());
  if (pose_count() > 0) add_covariances({0, pose_count()}, 0, {}, covariances);
  return covariances;
}

}  // namespace ribbon_mapper
