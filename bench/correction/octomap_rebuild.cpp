// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/correction/octomap_rebuild.hpp"

#include <octomap/OcTree.h>

#include "bench/stopwatch.hpp"
#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper::bench {
namespace {

constexpr double kVoxel_m = 0.05;

/// A scan in OctoMap's types.
struct Node {
  octomap::Pointcloud cloud;  // origin at the laser, axes of the base
  octomap::pose6d T_map_node;
};

octomap::point3d to_octomap(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

std::vector<Node> nodes_of(const Recording& tour, const ScanConfig& config) {
  std::vector<Node> nodes(tour.lines.size());
  ScanLine line;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    place_beams(tour.lines[k].beams, tour.lines[k].poses, config, line);
    const Pose T_base_odom = line.T_odom_base.inverse(Eigen::Isometry);
    const Eigen::Vector3d sensor = T_base_odom * line.origin(line.size() / 2);
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line.has_return(i)) {
        nodes[k].cloud.push_back(to_octomap(T_base_odom * line.points[i] - sensor));
      }
    }
    const Pose& T = tour.lines[k].T_map_base_true;
    const Eigen::Quaternionf q = Eigen::Quaterniond(T.linear()).cast<float>();
    nodes[k].T_map_node =
        octomap::pose6d(to_octomap(T * sensor), octomath::Quaternion(q.w(), q.x(), q.y(), q.z()));
  }
  return nodes;
}

}  // namespace

OctomapResult rebuild_octomap(const Recording& tour, const ScanConfig& config,
                              Insertion insertion) {
  const std::vector<Node> nodes = nodes_of(tour, config);
  const bool fast = insertion == Insertion::fast;
  octomap::OcTree tree(kVoxel_m);
  OctomapResult result;
  result.seconds = cpu_seconds_of([&] {
    for (const Node& node : nodes) {
      tree.insertPointCloud(node.cloud, octomap::point3d(0.0F, 0.0F, 0.0F), node.T_map_node, -1.0,
                            fast, fast);
    }
    if (fast) {
      tree.updateInnerOccupancy();
      tree.prune();
    }
  });
  result.tree_bytes = tree.memoryUsage();
  result.leaves = tree.getNumLeafNodes();
  return result;
}

}  // namespace ribbon_mapper::bench
