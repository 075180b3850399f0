// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "modeler/geometry/plane_fit.hpp"
#include "modeler/ribbon/line_observations.hpp"
#include "modeler/ribbon/sample_packer.hpp"
#include "modeler/ribbon/surfel.hpp"
#include "modeler/ribbon/surfel_clusters.hpp"

namespace ribbon_mapper {

/// Extracts the ribbons of a scan line (section 4.2 of the paper). Keeps its working memory from
/// line to line, and no other state.
class RibbonExtraction {
 public:
  /// Creates an extraction. Both configurations must be valid.
  RibbonExtraction(const ScanConfig& scan, const RibbonConfig& config);

  /// Returns the ribbons and the unassigned points of the middle line, with Ribbon::pose and
  /// UnassignedPoints::pose left 0. Valid until the next call.
  const LineObservations& extract(const ThreeLines& lines);

 private:
  /// Successive surfels of one cluster, without a bend.
  struct Run {
    BeamRange beams;
    BeamRange room;  ///< beams that the ribbon may grow into
    double area_m2;
  };
  /// Beams of three lines with the plane through their returns.
  struct FittedBeams {
    BeamRange beams;
    Moments moments;
    PlaneFit plane;
  };
  /// Successive returns that belong to no ribbon, as one point.
  struct LeftOver {
    Eigen::Vector3d from_sensor;
    std::size_t count;
  };

  void find_runs(const ScanLine& line);
  void add_run(const ScanLine& line, std::size_t first_surfel, std::size_t end_of_surfels,
               const BeamRange& room);
  void add_ribbon(const ThreeLines& lines, const Run& run);
  BeamRange widened(const ThreeLines& lines, const BeamRange& run) const;
  std::optional<FittedBeams> fit(const ThreeLines& lines, const BeamRange& run) const;
  bool straddles_an_edge(const ThreeLines& lines, const FittedBeams& fitted) const;
  bool lies_on(const PlaneFit& plane, const ScanLine& line, std::size_t beam) const;
  BeamRange grow(const ScanLine& line, BeamRange beams, const BeamRange& room,
                 const PlaneFit& plane) const;
  bool is_large_enough(const ScanLine& line, const BeamRange& beams, const PlaneFit& plane) const;
  Ribbon describe(const ThreeLines& lines, const BeamRange& beams, const FittedBeams& fitted);
  RibbonSamples samples_of(const ScanLine& line, const BeamRange& beams,
                           const Eigen::Vector3d& centroid, const Eigen::Vector3d& normal,
                           const Eigen::Vector3d& along);
  void link_samples();
  void find_left_over(const ScanLine& line);
  void pack_left_over(const ScanLine& line);

  ScanConfig scan_;
  RibbonConfig config_;
  SurfelClusters clusters_;
  SamplePacker packer_;
  LineObservations result_;
  Eigen::Vector3d sensor_origin_ = Eigen::Vector3d::Zero();  // of the middle beam, odom
  // Working memory of one line.
  std::vector<Surfel> surfels_;
  std::vector<Run> runs_;
  std::vector<char> is_taken_;  // by beam: it belongs to a ribbon
  std::vector<PackedSample> samples_;
  std::vector<LeftOver> left_over_;
  std::vector<PackedPoint> packed_points_;
};

}  // namespace ribbon_mapper
