// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "slam/matching/planar_pose.hpp"

namespace ribbon_mapper::slam {

/// A measured pose between two nodes of a graph.
struct GraphEdge {
  std::size_t from = 0, to = 0;                               ///< nodes
  PlanarPose T_from_to;                                       ///< as measured
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();  ///< of x, y, yaw in `from`
  /// Squared normalised errors far above it hardly count (Cauchy's kernel): the edge may be wrong.
  /// 0: it is right.
  double kernel = 0.0;
};

/// Poses with measurements between them. The first node is fixed.
class PoseGraph {
 public:
  /// Adds a node at a first guess, and returns its number.
  std::size_t add_node(const PlanarPose& guess);
  /// Adds an edge between nodes that exist. Throws std::invalid_argument otherwise.
  void add_edge(const GraphEdge& edge);
  /// Moves all nodes to where the edges agree best, by at most so many Gauss-Newton steps. Returns
  /// the largest move of a node [m].
  double optimise(int steps);

  /// Returns the squared normalised error of an edge.
  double chi2(const GraphEdge& edge) const;
  /// Returns the length of the shortest way over edges from a node to each node [m].
  std::vector<double> ways_from(std::size_t node) const;

  /// Returns the poses.
  const std::vector<PlanarPose>& poses() const { return poses_; }
  /// Returns the edges.
  const std::vector<GraphEdge>& edges() const { return edges_; }

 private:
  std::vector<PlanarPose> poses_;
  std::vector<GraphEdge> edges_;
};

}  // namespace ribbon_mapper::slam
