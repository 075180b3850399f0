// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "eval/metrics/patch.hpp"

namespace ribbon_mapper::eval {

/// When a plane of the model counts as a plane of the world.
struct MatchLimits {
  double max_angle_deg = 5.0;  ///< between the normals; both sides of a wall are 180 apart
  double max_offset_m = 0.10;  ///< of the estimate's centroid from the true plane
  double reach_m = 0.075;    ///< in the plane: cells (of 5 cm) nearer than this are the same place
  double min_overlap = 0.5;  ///< share of the estimate's cells, or of the truth's, in the other
};

/// How a model of planes compares with the world.
struct MapMetrics {
  std::size_t planes = 0;               ///< in the model
  std::size_t truth = 0;                ///< in the world
  std::size_t matched = 0;              ///< pairs, one to one
  std::vector<std::size_t> missed;      ///< indices of true planes without a partner
  std::vector<std::size_t> duplicates;  ///< indices of estimates of a true plane that has a partner
  std::vector<std::size_t> extra;       ///< indices of estimates of nothing that is there

  double precision = 0.0;  ///< matched / planes: duplicates count against it
  double recall = 0.0;     ///< matched / truth
  double f1 = 0.0;
  /// Share of the true area that a compatible estimate (angle, offset, side) has seen cells on.
  double coverage = 0.0;

  // Over matched pairs, nothing without any. Offset: of the estimate's centroid from the true
  // plane.
  std::optional<double> angle_error_deg_mean, angle_error_deg_median;
  std::optional<double> offset_error_m_mean, offset_error_m_median;
  /// Estimates per true plane that has one: (matched + duplicates) / matched.
  std::optional<double> duplication_ratio;
};

/// Pairs are taken in the order of the true cells they share, largest first; equals in the order
/// of their indices. The same input gives the same result. Takes time linear in the cells.
MapMetrics compare_maps(const std::vector<Patch>& estimates, const std::vector<Patch>& truth,
                        const MatchLimits& limits = {});

}  // namespace ribbon_mapper::eval
