// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "bench/recording/recording.hpp"
#include "modeler/scan/scan_config.hpp"

namespace ribbon_mapper::bench {

/// Modes of inserting scans into the tree.
enum class Insertion {
  as_documented,  ///< insertPointCloud() with default arguments
  fast,           ///< one point per voxel, inner nodes updated at the end
};

/// Result of rebuilding an OctoMap.
struct OctomapResult {
  double seconds = 0.0;        ///< CPU time from new poses to a consistent tree
  std::size_t tree_bytes = 0;  ///< OcTree::memoryUsage()
  std::size_t leaves = 0;      ///< number of leaf nodes
};

/// Builds a tree with voxels of 5 cm from all lines at their true poses. The lines are de-skewed
/// beforehand.
OctomapResult rebuild_octomap(const Recording& tour, const ScanConfig& config, Insertion insertion);

}  // namespace ribbon_mapper::bench
