// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/level/loop_finder.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "modeler/geometry/square.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr double kSearchSpacing_m = 0.2;
constexpr double kMatchSpacing_m = 0.1;

/// Returns how far two loops are from saying the same.
PlanarPose disagreement(const Loop& a, const Loop& b, const PoseGraph& graph) {
  const auto& poses = graph.poses();
  const PlanarPose by_b =
      relative(poses[a.from], poses[b.from]) * b.T_from_to * relative(poses[b.to], poses[a.to]);
  return relative(a.T_from_to, by_b);
}

}  // namespace

const char* text_of(LoopVerdict verdict) {
  switch (verdict) {
    case LoopVerdict::accepted:
      return "accepted";
    case LoopVerdict::ambiguous:
      return "another place fits nearly as well";
    case LoopVerdict::disagreeing:
      return "too few points agree";
    case LoopVerdict::unsupported:
      return "no second loop agrees";
    case LoopVerdict::contradicted:
      return "the other loops and the odometry contradict it";
  }
  return "";
}

double LoopFinder::radius_m(double way_m) const {
  return std::min(config_.most_radius_m, config_.radius_m + config_.radius_per_metre * way_m);
}

/// Returns the nearest keyframe of each stretch of way that may be here, and others along it.
std::vector<LoopFinder::Place> LoopFinder::places(const std::vector<Keyframe>& keyframes,
                                                  const PoseGraph& graph) const {
  const std::size_t newest = keyframes.size() - 1;
  const std::vector<double> ways = graph.ways_from(newest);
  const auto& poses = graph.poses();
  std::vector<Place> places;
  double nearest_m = 0.0, begin_m = 0.0;
  bool is_open = false;
  for (std::size_t k = 0; k < newest; ++k) {
    // the query and the reference must not share keyframes
    if (keyframes[newest].way_m - keyframes[k].way_m < config_.query_m) break;
    const double distance = distance_m(poses[k], poses[newest]);
    const bool is_possible =
        ways[k] > config_.least_way_m && distance < radius_m(ways[k]) + config_.view_m;
    if (!is_possible) {
      is_open = false;
      continue;
    }
    if (!is_open || keyframes[k].way_m - begin_m > config_.reference_m) {
      places.push_back({k, ways[k]});
      nearest_m = distance, begin_m = keyframes[k].way_m, is_open = true;
    } else if (distance < nearest_m) {
      places.back() = {k, ways[k]}, nearest_m = distance;
    }
  }
  return places;
}

LevelPoints LoopFinder::surroundings(const std::vector<Keyframe>& keyframes, const PoseGraph& graph,
                                     std::size_t centre, double before_m, double after_m,
                                     std::size_t end) const {
  LevelPoints points;
  const double way_m = keyframes[centre].way_m;
  std::size_t first = centre;
  while (first > 0 && way_m - keyframes[first - 1].way_m <= before_m) --first;
  for (std::size_t k = first; k < end && keyframes[k].way_m - way_m <= after_m; ++k)
    append_moved(keyframes[k].points, relative(graph.poses()[centre], graph.poses()[k]), points);
  return points;
}

const CorrelativeSearch& LoopFinder::map_of(const std::vector<Keyframe>& keyframes,
                                            const PoseGraph& graph, const Place& place,
                                            std::size_t end) {
  constexpr std::size_t kMostMaps = 100;  // of some megabytes
  auto& map = maps_[place.keyframe];
  if (!map) {
    map = std::make_unique<CorrelativeSearch>(surroundings(
        keyframes, graph, place.keyframe, config_.reference_m, config_.reference_m, end));
    if (maps_.size() > kMostMaps) {
      const auto far =
          maps_.begin()->first == place.keyframe ? std::prev(maps_.end()) : maps_.begin();
      maps_.erase(far);
    }
  }
  return *maps_[place.keyframe];
}

/// Searches and matches at one place. Returns whether there is something to be judged.
bool LoopFinder::judge(const std::vector<Keyframe>& keyframes, const PoseGraph& graph,
                       const Place& place, const LevelPoints& query, Loop& loop) {
  const std::size_t newest = keyframes.size() - 1;
  std::size_t end = newest;  // of the reference: before the query begins
  while (end > 0 && keyframes[newest].way_m - keyframes[end - 1].way_m < config_.query_m) --end;
  SearchWindow window{radius_m(place.way_m),
                      std::min(M_PI, config_.angle_rad + config_.angle_per_metre * place.way_m),
                      config_.least_score};
  const PlanarPose guess = relative(graph.poses()[place.keyframe], graph.poses()[newest]);
  ++searches_;
  const auto hit = map_of(keyframes, graph, place, end)
                       .find(thinned(query, kSearchSpacing_m), guess, window, config_.second_share);
  if (!hit) return false;
  const SurfaceMap map(surroundings(keyframes, graph, place.keyframe, config_.reference_m,
                                    config_.reference_m, end));
  const Match found =
      match(thinned(query, kMatchSpacing_m), map, hit->T_map_base, std::nullopt, match_);
  Eigen::Matrix3d covariance = (found.information + 1e-3 * Eigen::Matrix3d::Identity()).inverse();
  covariance.diagonal() +=
      Eigen::Vector3d(square(config_.place_m), square(config_.place_m), square(config_.place_rad));
  const Eigen::Matrix3d information = covariance.inverse();
  loop = {place.keyframe, newest,      found.T_map_base,
          information,    hit->score,  hit->second_score,
          found.agreeing, place.way_m, LoopVerdict::unsupported};
  if (found.agreeing < config_.least_agreeing)
    loop.verdict = LoopVerdict::disagreeing;
  else if (hit->second_score > 0.0)
    loop.verdict = LoopVerdict::ambiguous;
  return true;
}

/// Accepts a loop if it is near or has support, and those that it supports.
void LoopFinder::add(const Loop& loop, const PoseGraph& graph, std::vector<Loop>& accepted) {
  judged_.push_back(loop);
  Loop& added = judged_.back();
  if (added.verdict != LoopVerdict::unsupported) return;
  bool is_accepted = radius_m(added.way_m) <= config_.lone_radius_m;
  for (auto other = pending_.begin(); other != pending_.end();) {
    Loop& pending = judged_[*other];
    const PlanarPose apart = disagreement(added, pending, graph);
    const bool is_same = apart.translation().norm() < config_.support_m &&
                         std::abs(apart.yaw_rad) < config_.support_rad;
    if (!is_same) {
      ++other;
      continue;
    }
    is_accepted = true;
    pending.verdict = LoopVerdict::accepted;
    accepted.push_back(pending);
    other = pending_.erase(other);
  }
  if (!is_accepted) {
    pending_.push_back(judged_.size() - 1);
    return;
  }
  added.verdict = LoopVerdict::accepted;
  accepted.push_back(added);
}

std::vector<Loop> LoopFinder::find(const std::vector<Keyframe>& keyframes, const PoseGraph& graph) {
  std::vector<Loop> accepted;
  const double way_m = keyframes.back().way_m;
  if (way_m - last_attempt_m_ < config_.every_m) return accepted;
  last_attempt_m_ = way_m;
  pending_.erase(std::remove_if(pending_.begin(), pending_.end(),
                                [&](std::size_t i) {
                                  return way_m - keyframes[judged_[i].to].way_m >
                                         config_.support_way_m;
                                }),
                 pending_.end());
  const LevelPoints query =
      surroundings(keyframes, graph, keyframes.size() - 1, config_.query_m, 0.0, keyframes.size());
  for (const Place& place : places(keyframes, graph)) {
    Loop loop;
    if (judge(keyframes, graph, place, query, loop)) add(loop, graph, accepted);
  }
  return accepted;
}

}  // namespace ribbon_mapper::slam
