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

/// The part of a plane of the world that beams hit: a connected patch of 5 cm cells. Its faces have
/// the same visible side, normal (within 0.5 degrees) and offset (within 1 cm). Gaps of at most 1 m
/// are bridged, so a wall with a door in it is one plane. Patches below 0.5 m2 and curved faces are
/// not planes.
struct TruthPlane {
  int id = 0;                                         ///< position in TruthCollector::planes()
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< towards the laser
  double d_m = 0.0;                                   ///< n.p + d = 0 in map
  double area_m2 = 0.0;                               ///< of the cells
  Eigen::Vector3d axis_u = Eigen::Vector3d::UnitX();  ///< direction of the cells' rows
  std::vector<Eigen::Vector3d> cells;  ///< centres of the hit cells, in map, on the plane
  std::vector<int> cell_numbers;       ///< of the cells, as TruthCollector::add() returns them
  std::vector<int> cell_faces;         ///< of the cells: indices into World::faces()
  std::vector<int> faces;              ///< all of these, once each
};

/// Collects where the beams of a tour truly hit the world.
class TruthCollector {
 public:
  /// Starts without hits. The world must outlive the collector.
  explicit TruthCollector(const World& world);
  ~TruthCollector();

  /// Adds a hit without noise, in map; `face` is that of World::cast(), -1 is ignored. The beam's
  /// origin decides which side was seen: the sides of a thin wall are separate planes. Returns the
  /// number of the cell, the same at each hit, or -1 if the hit is not on a planar face.
  int add(const Eigen::Vector3d& point_map, const Eigen::Vector3d& origin_map, int face);

  /// Adds all hits of a scan. Returns the number of each beam's cell, -1 as above.
  std::vector<int> add(const Scan& scan);

  /// Returns the planes seen so far, largest first. A smaller `min_area_m2` returns small patches,
  /// too.
  std::vector<TruthPlane> planes(double min_area_m2 = 0.5) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ribbon_mapper::sim
