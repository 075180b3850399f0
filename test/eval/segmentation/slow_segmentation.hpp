// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "eval/segmentation/evops.hpp"

namespace ribbon_mapper::eval {

/// Indices of the points of a region.
using Region = std::set<int>;

/// The regions of a segmentation.
using Regions = std::vector<Region>;

/// The SegComp class of each true region and of each estimate.
struct SlowSegComp {
  std::vector<std::string> truth;      ///< "correct", "over", "under" or "missed"
  std::vector<std::string> estimates;  ///< "correct", "over", "under" or "noise"
};

/// Classifies regions by the literal definitions of SegComp, slowly.
SlowSegComp slow_segcomp(const Regions& truth, const Regions& estimates, double tolerance);

/// Computes the scores by the literal definitions of prime-slam/evops-metrics, slowly.
Evops slow_evops(const Regions& truth, const Regions& estimates);

}  // namespace ribbon_mapper::eval
