// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

#include "sim/robot/hokuyo.hpp"
#include "sim/world/world.hpp"

namespace ribbon_mapper::sim {

/// A plane of the world as far as the beams saw it: a connected patch of 5 cm cells on world faces
/// with the same side, normal (within 0.5 degrees) and offset (within 1 cm); gaps of at most 1.0 m
/// are bridged, patches below 0.5 m2 are no planes, curved faces neither (design: Truth).
struct TruthPlane {
  int id = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< towards the side that the beams came from
  double d_m = 0.0;                                   ///< n.p + d = 0 in map
  double area_m2 = 0.0;
  std::vector<Eigen::Vector3d> cells;  ///< centres of the hit cells, in map, on the plane
  std::vector<int> cell_numbers;       ///< of the cells, as TruthCollector::add() gave them
  std::vector<int> faces;              ///< indices into World::faces()
};

/// Collects where beams really hit the world.
class TruthCollector {
 public:
  explicit TruthCollector(const World& world);
  ~TruthCollector();
  /// A hit without noise, in map; `face` as World::cast() gives it (-1 is ignored). The beam's
  /// origin tells the side: both sides of a thin wall are planes of their own. Returns the number
  /// of the cell that was hit, the same at every hit; -1 if the hit is on no planar face.
  int add(const Eigen::Vector3d& point_map, const Eigen::Vector3d& origin_map, int face);
  /// All hits of a scan. Returns the number of the cell that each beam hit.
  std::vector<int> add(const Scan& scan);
  /// Truth planes seen so far, largest first. A smaller `min_area_m2` shows what fell short.
  std::vector<TruthPlane> planes(double min_area_m2 = 0.5) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ribbon_mapper::sim
