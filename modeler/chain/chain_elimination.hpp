// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "modeler/chain/chain_system.hpp"

namespace ribbon_mapper {

/// Eliminates the unknowns of a ChainSystem in the order of a balanced tree.
///
/// Each node of the tree is a range of poses. It eliminates the range's middle pose, and the
/// landmarks that only the range observes.
class ChainElimination {
 public:
  /// Eliminates all unknowns, from the leaves to the root. `system` must outlive this.
  explicit ChainElimination(const ChainSystem& system);

  /// Returns the solution, from the root to the leaves.
  ChainSystem::Solution solution() const;
  /// Returns the covariances of the poses' errors, from the root to the leaves.
  std::vector<Matrix6> pose_covariances();

 private:
  /// The pose or the landmark of this number.
  struct Unknown {
    bool is_landmark;
    std::uint32_t number;
    Eigen::Index size() const { return is_landmark ? 3 : 6; }
  };
  /// Poses [first, end).
  struct Range {
    std::uint32_t first, end;
    std::uint32_t size() const { return end - first; }
    std::uint32_t middle() const { return first + (end - first) / 2; }
    bool is_empty() const { return first >= end; }
    Range before() const { return {first, middle()}; }
    Range behind() const { return {middle() + 1, end}; }
  };
  /// A dense symmetric matrix of some unknowns.
  struct Block {
    std::vector<Unknown> unknowns;
    std::vector<Eigen::Index> offsets;  // by unknown
    Eigen::MatrixXd matrix;
  };
  /// A part of the equations: `eliminated` unknowns come first, then those that remain.
  struct Front : Block {
    Eigen::VectorXd vector;
  };
  /// What is left to do once the remaining unknowns of a front are known.
  struct Elimination {
    std::vector<Unknown> eliminated, remaining;
    Eigen::LLT<Eigen::MatrixXd> factor;  // of the block of the eliminated
    Eigen::MatrixXd coupling;            // block^-1 * (block between eliminated and remaining)
    Eigen::VectorXd vector;              // block^-1 * right-hand side
  };

  std::uint32_t pose_count() const { return static_cast<std::uint32_t>(system_.poses_.size()); }
  static Eigen::Index size_of(const std::vector<Unknown>& unknowns);
  static void list_offsets(Block& block);
  Front eliminate(const Range& range);
  std::vector<Unknown> unknowns_of(const Range& range, const std::vector<Front>& children,
                                   std::size_t& eliminated);
  void add_own_equations(const Range& range, Front& front, std::size_t eliminated);
  void extend_add(const Front& child, Front& front);
  Front reduced(const Front& front, std::size_t eliminated);
  void index(const Block& block);
  Eigen::Index& offset_of(const Unknown& unknown) {
    return unknown.is_landmark ? landmark_offsets_[unknown.number] : pose_offsets_[unknown.number];
  }
  Eigen::MatrixXd part_of(const Block& above, const std::vector<Unknown>& unknowns);
  void add_covariances(const Range& range, std::size_t first_step, const Block& above,
                       std::vector<Matrix6>& covariances);

  const ChainSystem& system_;
  std::vector<Range> observed_;                 // by landmark: from the first to the last pose
  std::vector<Eigen::Index> pose_offsets_;      // in the block that was indexed last
  std::vector<Eigen::Index> landmark_offsets_;  // the same
  std::vector<Elimination> eliminations_;       // before, behind, then the middle of a range
  std::vector<std::uint32_t> marks_;            // by landmark: last front that listed it
  std::uint32_t mark_ = 0;
};

}  // namespace ribbon_mapper
