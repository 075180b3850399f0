// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/level/level_slam.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ribbon_mapper::slam {
namespace {

constexpr int kStepsOnTheWay = 3;
constexpr int kStepsInTheEnd = 20;
/// Loops that say what the graph knows wait for others: a step takes longer the larger the graph.
constexpr double kSurprising = 6.0;  // squared normalised error of three numbers, 90 %
constexpr std::size_t kManyLoops = 10;
constexpr double kBent_m = 0.2;  // maps of places are made anew after so large a correction

void require_finite(const LevelScan& scan, const PlanarPose& pose) {
  bool is_finite = pose.vector().allFinite();
  for (const LevelPoint& p : scan.points) {
    is_finite = is_finite && std::isfinite(p.x_m) && std::isfinite(p.y_m) &&
                std::isfinite(p.normal_x) && std::isfinite(p.normal_y);
  }
  if (!is_finite) throw std::invalid_argument("a scan or its odometry is not finite: leave it out");
}

GraphEdge edge_of(const Loop& loop, double kernel) {
  return {loop.from, loop.to, loop.T_from_to, loop.information, kernel};
}

}  // namespace

LevelSlam::LevelSlam(const LevelSlamConfig& config)
    : config_(config),
      tracker_(config.tracker, config.match, config.odometry),
      loops_(config.loop, config.match) {}

void LevelSlam::add(const LevelScan& scan, const PlanarPose& T_odom_base) {
  require_finite(scan, T_odom_base);
  if (!stamps_.empty() && scan.stamp <= stamps_.back())
    throw std::invalid_argument("a scan is not later than the one before: leave it out");
  const TrackedScan tracked = tracker_.add(scan, T_odom_base);
  scans_.push_back({scan.points, tracked});
  stamps_.push_back(scan.stamp);
  if (!tracked.is_keyframe) return;
  add_to_graph();
  close_loops();
}

void LevelSlam::add_to_graph() {
  const Keyframe& keyframe = tracker_.keyframes().back();
  if (graph_.poses().empty()) {
    graph_.add_node({});
    return;
  }
  const std::size_t last = graph_.poses().size() - 1;
  graph_.add_node(graph_.poses().back() * keyframe.T_before_base);
  graph_.add_edge({last, last + 1, keyframe.T_before_base, keyframe.information, 0.0});
}

void LevelSlam::close_loops() {
  double most = 0.0;
  for (const Loop& loop : loops_.find(tracker_.keyframes(), graph_)) {
    const GraphEdge edge = edge_of(loop, config_.loop.kernel);
    graph_.add_edge(edge);
    most = std::max(most, graph_.chi2(edge));
    ++new_loops_;
  }
  if (new_loops_ == 0 || (most < kSurprising && new_loops_ < kManyLoops)) return;
  new_loops_ = 0;
  if (graph_.optimise(kStepsOnTheWay) > kBent_m) loops_.forget_maps();
}

/// Solves the graph without the loops that all others contradict, and returns all loops.
std::vector<Loop> LevelSlam::settle() {
  std::vector<Loop> loops = loops_.judged();
  graph_.optimise(kStepsInTheEnd);
  PoseGraph settled;
  for (const PlanarPose& pose : graph_.poses()) settled.add_node(pose);
  for (const GraphEdge& edge : graph_.edges())
    if (edge.kernel <= 0.0) settled.add_edge(edge);
  for (Loop& loop : loops) {
    if (loop.verdict != LoopVerdict::accepted) continue;
    const GraphEdge edge = edge_of(loop, config_.loop.kernel);
    if (graph_.chi2(edge) > config_.loop.contradicted_chi2)
      loop.verdict = LoopVerdict::contradicted;
    else
      settled.add_edge(edge);
  }
  settled.optimise(kStepsInTheEnd);
  graph_ = std::move(settled);
  return loops;
}

LevelSlamResult LevelSlam::finish() {
  LevelSlamResult result;
  result.loops = settle();
  for (const Keyframe& keyframe : tracker_.keyframes())
    result.keyframe_stamps.push_back(stamps_[keyframe.scan]);
  const std::vector<PlanarPose> poses =
      final_poses(scans_, tracker_.keyframes(), graph_.poses(), config_.final_match, config_.match);
  for (std::size_t i = 0; i < poses.size(); ++i)
    result.trajectory.push_back({stamps_[i], poses[i]});
  return result;
}

}  // namespace ribbon_mapper::slam
