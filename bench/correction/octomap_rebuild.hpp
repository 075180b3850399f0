// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "bench/recording/recording.hpp"
#include "modeler/scan/scan_config.hpp"

namespace ribbon_mapper::bench {

/// How the scans go into the tree.
enum class Insertion {
  as_documented,  ///< insertPointCloud() as it comes
  fast,           ///< points of one voxel once, inner nodes at the end
};

struct OctomapResult {
  double seconds = 0.0;        ///< from new poses to a consistent tree
  std::size_t tree_bytes = 0;  ///< OcTree::memoryUsage()
  std::size_t leaves = 0;
};

/// A tree of 5 cm, rebuilt from the lines at their true poses. The lines are nodes in the laser's
/// frame, de-skewed before.
OctomapResult rebuild_octomap(const Recording& tour, const ScanConfig& config, Insertion insertion);

}  // namespace ribbon_mapper::bench
