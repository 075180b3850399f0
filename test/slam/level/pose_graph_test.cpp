// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/level/pose_graph.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ribbon_mapper::slam {
namespace {

constexpr std::size_t kNodes = 40;

/// Returns poses on a circle of 5 m, each heading along it.
std::vector<PlanarPose> circle() {
  std::vector<PlanarPose> poses;
  for (std::size_t i = 0; i < kNodes; ++i) {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / kNodes;
    poses.push_back({5.0 * std::cos(angle), 5.0 * std::sin(angle), wrapped(angle + M_PI / 2.0)});
  }
  return poses;
}

GraphEdge edge(const std::vector<PlanarPose>& truth, std::size_t from, std::size_t to) {
  return {from, to, relative(truth[from], truth[to]), 1e4 * Eigen::Matrix3d::Identity(), 0.0};
}

/// Returns a graph whose steps turn too much, so that it does not close.
PoseGraph drifting_graph(const std::vector<PlanarPose>& truth) {
  PoseGraph graph;
  graph.add_node(truth[0]);
  for (std::size_t i = 1; i < kNodes; ++i) {
    GraphEdge step = edge(truth, i - 1, i);
    step.T_from_to.yaw_rad += 0.02;
    graph.add_node(graph.poses().back() * step.T_from_to);
    graph.add_edge(step);
  }
  return graph;
}

double largest_error_m(const PoseGraph& graph, const std::vector<PlanarPose>& truth) {
  double most = 0.0;
  for (std::size_t i = 0; i < kNodes; ++i)
    most = std::max(most, distance_m(graph.poses()[i], truth[i]));
  return most;
}

TEST(PoseGraph, ReturnsToTheRingThatExactEdgesDescribe) {
  const std::vector<PlanarPose> truth = circle();
  PoseGraph graph;
  for (std::size_t i = 0; i < kNodes; ++i)  // far from the truth
    graph.add_node(i == 0
                       ? truth[0]
                       : truth[i] * PlanarPose{0.3, -0.2, 0.1 * std::sin(static_cast<double>(i))});
  for (std::size_t i = 1; i < kNodes; ++i) graph.add_edge(edge(truth, i - 1, i));
  graph.add_edge(edge(truth, kNodes - 1, 0));
  EXPECT_GT(graph.optimise(20), 0.1);
  EXPECT_LT(largest_error_m(graph, truth), 1e-6);
  EXPECT_LT(graph.chi2(graph.edges().back()), 1e-9);
}

TEST(PoseGraph, ALoopTakesTheDriftOut) {
  const std::vector<PlanarPose> truth = circle();
  PoseGraph graph = drifting_graph(truth);
  const double before = largest_error_m(graph, truth);
  GraphEdge loop = edge(truth, 0, kNodes - 1);
  loop.information *= 100.0;
  graph.add_edge(loop);
  graph.optimise(20);
  EXPECT_LT(largest_error_m(graph, truth), 0.2 * before);
}

TEST(PoseGraph, AWrongLoopHardlyCounts) {
  const std::vector<PlanarPose> truth = circle();
  PoseGraph graph;
  graph.add_node(truth[0]);
  for (std::size_t i = 1; i < kNodes; ++i) {
    graph.add_node(truth[i]);
    graph.add_edge(edge(truth, i - 1, i));
  }
  for (const std::size_t from : {0U, 5U, 10U, 15U}) graph.add_edge(edge(truth, from, from + 22));
  GraphEdge wrong = edge(truth, 0, kNodes / 2);
  wrong.T_from_to.x_m += 4.0, wrong.kernel = 9.0;
  graph.add_edge(wrong);
  graph.optimise(20);
  EXPECT_LT(largest_error_m(graph, truth), 0.3);
  EXPECT_GT(graph.chi2(wrong), 1000.0);
}

TEST(PoseGraph, TheFirstNodeStays) {
  const std::vector<PlanarPose> truth = circle();
  PoseGraph graph = drifting_graph(truth);
  graph.add_edge(edge(truth, 0, kNodes - 1));
  graph.optimise(20);
  EXPECT_EQ(distance_m(graph.poses()[0], truth[0]), 0.0);
}

TEST(PoseGraph, WaysAreTheShortestOnes) {
  const std::vector<PlanarPose> truth = circle();
  PoseGraph graph = drifting_graph(truth);
  const double step = distance_m(truth[0], truth[1]);
  EXPECT_NEAR(graph.ways_from(0)[kNodes - 1], step * static_cast<double>(kNodes - 1), 1e-9);
  graph.add_edge(edge(truth, kNodes - 1, 0));
  EXPECT_NEAR(graph.ways_from(0)[kNodes - 1], step, 1e-9);
  EXPECT_NEAR(graph.ways_from(0)[kNodes / 2], step * (kNodes / 2), 1e-9);
}

TEST(PoseGraph, RefusesEdgesWithoutNodes) {
  PoseGraph graph;
  EXPECT_EQ(graph.optimise(5), 0.0);
  graph.add_node({});
  EXPECT_THROW(graph.add_edge({0, 1, {}, Eigen::Matrix3d::Identity(), 0.0}), std::invalid_argument);
  EXPECT_THROW(graph.add_edge({0, 0, {}, Eigen::Matrix3d::Identity(), 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace ribbon_mapper::slam
