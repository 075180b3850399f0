// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "eval/metrics/patch.hpp"

namespace ribbon_mapper::eval {

/// Limits within which a plane of the model matches a plane of the world.
struct MatchLimits {
  double max_angle_deg = 5.0;  ///< between the normals; the sides of a wall are 180 apart
  double max_offset_m = 0.10;  ///< of the estimate's centroid from the true plane
  double reach_m = 0.075;      ///< in the plane: cells (of 5 cm) nearer than this coincide
  double min_overlap = 0.5;    ///< share of the estimate's cells, or of the truth's, in the other
};

/// An estimate and the true plane that it matches.
struct Match {
  std::size_t estimate = 0;  ///< index of the estimate
  std::size_t truth = 0;     ///< index of the true plane
};

/// Result of comparing a model of planes with the world.
struct MapMetrics {
  std::size_t planes = 0;               ///< number of planes in the model
  std::size_t truth = 0;                ///< number of planes in the world
  std::size_t matched = 0;              ///< number of one-to-one pairs
  std::vector<Match> matches;           ///< these pairs
  std::vector<std::size_t> missed;      ///< indices of true planes without a partner
  std::vector<std::size_t> duplicates;  ///< indices of further estimates of a matched plane
  std::vector<std::size_t> extra;       ///< indices of estimates that match no true plane

  double precision = 0.0;  ///< matched / planes: duplicates count against it
  double recall = 0.0;     ///< matched / truth
  double f1 = 0.0;         ///< harmonic mean of precision and recall
  /// Share of the true area where an estimate within the limits has seen cells.
  double coverage = 0.0;

  // Errors over matched pairs; empty if there are none.
  std::optional<double> angle_error_deg_mean;    ///< mean angle between the normals
  std::optional<double> angle_error_deg_median;  ///< median angle between the normals
  /// Mean distance of the estimates' centroids from their true planes.
  std::optional<double> offset_error_m_mean;
  /// Median distance of the estimates' centroids from their true planes.
  std::optional<double> offset_error_m_median;
  /// See outline_iou(); empty if the planes have no outlines.
  std::optional<double> outline_iou;
  /// Estimates per matched true plane: (matched + duplicates) / matched.
  std::optional<double> duplication_ratio;
};

/// Compares planes of a model with those of the world. Pairs are assigned greedily by the number of
/// true cells that they share; ties are broken by smaller offset, then by index. The result is
/// deterministic; the time is linear in the number of cells.
MapMetrics compare_maps(const std::vector<Patch>& estimates, const std::vector<Patch>& truth,
                        const MatchLimits& limits = {});

}  // namespace ribbon_mapper::eval
