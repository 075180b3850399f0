// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/ribbon/packed_store.hpp"
#include "modeler/ribbon/ribbon.hpp"
#include "modeler/ribbon/sample_packer.hpp"
#include "modeler/ribbon/surfel.hpp"
#include "modeler/ribbon/surfel_clusters.hpp"
#include "modeler/ribbon/unassigned_points.hpp"

namespace ribbon_mapper {

/// Where the samples of ribbons and the stray points are kept.
struct PointStore {
  PackedStore<PackedSample> samples;
  PackedStore<PackedPoint> unassigned;
};

/// Section 4.2 on the three lines of a full buffer. Keeps its working memory from line to line, no
/// state beyond it.
class RibbonExtraction {
 public:
  RibbonExtraction(const ScanConfig& scan, const RibbonConfig& config);

  /// Ribbons of the buffer's middle line in the order of its beams; `pose` is left 0.
  /// Valid until the next call, their samples as long as the store.
  const std::vector<Ribbon>& extract(const LineBuffer& buffer, PointStore& store);

  /// What is left of that line.
  UnassignedPoints unassigned(const LineBuffer& buffer, PointStore& store);

 private:
  struct Run {
    std::size_t begin, end;  // beams of the middle line
    double area_m2;
  };

  void find_runs(const ScanLine& line);
  void make_ribbon(const LineBuffer& buffer, const Run& run, PointStore& store);
  bool lies_on(const PlaneFit& plane, const ScanLine& line, std::size_t beam) const;
  Run grow(const ScanLine& line, Run run, const PlaneFit& plane) const;
  RibbonSamples samples_of(const ScanLine& line, const Run& run, const Eigen::Vector3d& centroid,
                           const Eigen::Vector3d& normal, const Eigen::Vector3d& along,
                           PointStore& store);
  void collect_unassigned(const ScanLine& line);
  bool straddles_an_edge(const LineBuffer& buffer, const Run& core, const PlaneFit& plane) const;

  ScanConfig scan_;
  RibbonConfig config_;
  SurfelClusters clusters_;
  std::vector<Surfel> surfels_;
  Eigen::Vector3d sensor_origin_ = Eigen::Vector3d::Zero();
  std::vector<Run> runs_;
  std::vector<char> taken_;  // beams that belong to a ribbon
  std::vector<Ribbon> ribbons_;
  SamplePacker packer_;
  struct Stray {
    Eigen::Vector3d from_sensor;
    std::size_t count;
  };
  std::vector<Stray> unassigned_;
  std::vector<PackedPoint> packed_unassigned_;
};

}  // namespace ribbon_mapper
