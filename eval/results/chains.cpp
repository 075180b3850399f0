// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/results/chains.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace ribbon_mapper::eval {
namespace {

using Node = std::pair<std::int64_t, std::int64_t>;  // a position, rounded to the tolerance

/// Segments as a graph of positions. Walking along an edge removes it.
class Graph {
 public:
  Graph(const std::vector<Segment>& segments, double tolerance_m) {
    for (const Segment& segment : segments) {
      const Node a = node_at(segment[0], tolerance_m), b = node_at(segment[1], tolerance_m);
      if (a == b) continue;
      neighbours_[a].insert(b);
      neighbours_[b].insert(a);
    }
  }

  /// Returns the chain from `node` on until no edge is left to walk.
  Chain walk(Node node) {
    Chain chain{places_[node]};
    while (!neighbours_[node].empty()) {
      const Node next = *neighbours_[node].begin();
      neighbours_[node].erase(next);
      neighbours_[next].erase(node);
      chain.push_back(places_[next]);
      node = next;
    }
    return chain;
  }

  /// Returns all chains: first those from open ends and junctions, then the closed ones.
  std::vector<Chain> walks() {
    std::vector<Chain> chains;
    for (const bool only_odd : {true, false}) {
      for (const auto& [node, place] : places_) {
        while (!neighbours_[node].empty() && (!only_odd || neighbours_[node].size() % 2 == 1)) {
          chains.push_back(walk(node));
        }
      }
    }
    return chains;
  }

 private:
  Node node_at(const Eigen::Vector2d& place, double tolerance_m) {
    const Node node{std::llround(place.x() / tolerance_m), std::llround(place.y() / tolerance_m)};
    places_.emplace(node, place);
    return node;
  }

  std::map<Node, Eigen::Vector2d> places_;  // sorted, so that the result is deterministic
  std::map<Node, std::set<Node>> neighbours_;
};

double distance_from_line(const Eigen::Vector2d& point, const Eigen::Vector2d& begin,
                          const Eigen::Vector2d& end) {
  const Eigen::Vector2d along = end - begin, to_point = point - begin;
  const double length = along.norm();
  if (length == 0.0) return to_point.norm();
  return std::abs(along.x() * to_point.y() - along.y() * to_point.x()) / length;
}

/// Marks the points to keep between two kept ones.
void keep_between(const Chain& chain, std::size_t first, std::size_t last, double tolerance_m,
                  std::vector<bool>& is_kept) {
  std::size_t furthest = first;
  double distance_m = tolerance_m;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double d = distance_from_line(chain[i], chain[first], chain[last]);
    if (d <= distance_m) continue;
    distance_m = d;
    furthest = i;
  }
  if (furthest == first) return;
  is_kept[furthest] = true;
  keep_between(chain, first, furthest, tolerance_m, is_kept);
  keep_between(chain, furthest, last, tolerance_m, is_kept);
}

}  // namespace

std::vector<Chain> chains_of(const std::vector<Segment>& segments, double tolerance_m) {
  std::vector<Chain> chains = Graph(segments, tolerance_m).walks();
  for (Chain& chain : chains) chain = simplified(chain, tolerance_m);
  return chains;
}

Chain simplified(const Chain& chain, double tolerance_m) {
  if (chain.size() < 3) return chain;
  std::vector<bool> is_kept(chain.size(), false);
  is_kept.front() = is_kept.back() = true;
  keep_between(chain, 0, chain.size() - 1, tolerance_m, is_kept);
  Chain kept;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (is_kept[i]) kept.push_back(chain[i]);
  }
  return kept;
}

}  // namespace ribbon_mapper::eval
