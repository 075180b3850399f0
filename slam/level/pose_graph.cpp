// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/level/pose_graph.hpp"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>

namespace ribbon_mapper::slam {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// The error of an edge and its derivatives by both poses.
struct Linearised {
  Eigen::Vector3d error;
  Eigen::Matrix3d by_from, by_to;
};

Linearised linearised(const GraphEdge& edge, const PlanarPose& from, const PlanarPose& to) {
  const double c = std::cos(from.yaw_rad), s = std::sin(from.yaw_rad);
  const Eigen::Vector2d way = to.translation() - from.translation();
  Eigen::Matrix2d R_inverse, derivative;
  R_inverse << c, s, -s, c;
  derivative << -s, c, -c, -s;
  Linearised l;
  l.error.head<2>() = R_inverse * way - edge.T_from_to.translation();
  l.error.z() = wrapped(to.yaw_rad - from.yaw_rad - edge.T_from_to.yaw_rad);
  l.by_to.setIdentity(), l.by_from = -Eigen::Matrix3d::Identity();
  l.by_to.topLeftCorner<2, 2>() = R_inverse;
  l.by_from.topLeftCorner<2, 2>() = -R_inverse;
  l.by_from.topRightCorner<2, 1>() = derivative * way;
  return l;
}

/// Adds a 3 x 3 block of the lower triangle. Node 0 is fixed: it has no rows.
void add_block(std::size_t row, std::size_t column, const Eigen::Matrix3d& block, Triplets& into) {
  if (row == 0 || column == 0) return;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int r = static_cast<int>(3 * row - 3) + i, c = static_cast<int>(3 * column - 3) + j;
      if (r >= c) into.emplace_back(r, c, block(i, j));
    }
  }
}

double weight_of(const GraphEdge& edge, double chi2) {
  return edge.kernel > 0.0 ? 1.0 / (1.0 + chi2 / edge.kernel) : 1.0;
}

}  // namespace

std::size_t PoseGraph::add_node(const PlanarPose& guess) {
  poses_.push_back(guess);
  return poses_.size() - 1;
}

void PoseGraph::add_edge(const GraphEdge& edge) {
  if (edge.from >= poses_.size() || edge.to >= poses_.size() || edge.from == edge.to)
    throw std::invalid_argument("an edge needs two different nodes that were added before");
  edges_.push_back(edge);
}

double PoseGraph::chi2(const GraphEdge& edge) const {
  const Eigen::Vector3d e = linearised(edge, poses_[edge.from], poses_[edge.to]).error;
  return e.dot(edge.information * e);
}

double PoseGraph::optimise(int steps) {
  if (poses_.size() < 2) return 0.0;
  const std::vector<PlanarPose> before = poses_;
  const auto size = static_cast<Eigen::Index>(3 * poses_.size() - 3);
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
  for (int step = 0; step < steps; ++step) {
    Triplets triplets;
    triplets.reserve(27 * edges_.size());
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(size);
    for (const GraphEdge& edge : edges_) {
      const Linearised l = linearised(edge, poses_[edge.from], poses_[edge.to]);
      const Eigen::Matrix3d W =
          weight_of(edge, l.error.dot(edge.information * l.error)) * edge.information;
      add_block(edge.from, edge.from, l.by_from.transpose() * W * l.by_from, triplets);
      add_block(edge.to, edge.to, l.by_to.transpose() * W * l.by_to, triplets);
      add_block(edge.to, edge.from, l.by_to.transpose() * W * l.by_from, triplets);
      add_block(edge.from, edge.to, l.by_from.transpose() * W * l.by_to, triplets);
      if (edge.from > 0)
        gradient.segment<3>(3 * edge.from - 3) += l.by_from.transpose() * W * l.error;
      if (edge.to > 0) gradient.segment<3>(3 * edge.to - 3) += l.by_to.transpose() * W * l.error;
    }
    for (int i = 0; i < size; ++i) triplets.emplace_back(i, i, 1e-9);  // of nodes without edges
    Eigen::SparseMatrix<double> H(size, size);
    H.setFromTriplets(triplets.begin(), triplets.end());
    if (step == 0) solver.analyzePattern(H);
    solver.factorize(H);
    if (solver.info() != Eigen::Success) break;
    const Eigen::VectorXd delta = solver.solve(-gradient);
    for (std::size_t i = 1; i < poses_.size(); ++i)
      poses_[i] = planar(poses_[i].vector() + delta.segment<3>(3 * i - 3));
    if (delta.lpNorm<Eigen::Infinity>() < 1e-4) break;
  }
  double most = 0.0;
  for (std::size_t i = 0; i < poses_.size(); ++i)
    most = std::max(most, distance_m(before[i], poses_[i]));
  return most;
}

std::vector<double> PoseGraph::ways_from(std::size_t node) const {
  std::vector<std::vector<std::pair<std::size_t, double>>> next(poses_.size());
  for (const GraphEdge& edge : edges_) {
    const double length = edge.T_from_to.translation().norm();
    next[edge.from].emplace_back(edge.to, length), next[edge.to].emplace_back(edge.from, length);
  }
  std::vector<double> ways(poses_.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  open.emplace(ways[node] = 0.0, node);
  while (!open.empty()) {
    const auto [way, at] = open.top();
    open.pop();
    if (way > ways[at]) continue;
    for (const auto& [to, length] : next[at])
      if (way + length < ways[to]) open.emplace(ways[to] = way + length, to);
  }
  return ways;
}

}  // namespace ribbon_mapper::slam
