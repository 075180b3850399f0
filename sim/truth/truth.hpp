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
  std::vector<int> faces;              ///< indices into World::faces()
};

/// A cell of 5 cm of the world's planar faces that beams hit.
struct TruthCell {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< in map, on the face
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< towards the laser
  int face = 0;                                       ///< index into World::faces()
};

/// Collects where the beams of a tour truly hit the world.
class TruthCollector {
 public:
  /// Starts without hits. The world must outlive the collector.
  explicit TruthCollector(const World& world);
  ~TruthCollector();

  /// Adds a hit without noise, in map; `face` is that of World::cast(), -1 is ignored. The beam's
  /// origin decides which side was seen: the sides of a thin wall are separate planes. The robot
  /// stands at the height `ground_m`. Returns the number of the cell, the same at each hit, or -1
  /// if the hit is not on a planar face.
  int add(const Eigen::Vector3d& point_map, const Eigen::Vector3d& origin_map, int face,
          double ground_m = 0.0);

  /// Adds all hits of a scan. Returns the number of each beam's cell, -1 as above.
  std::vector<int> add(const Scan& scan);

  /// Returns the planes seen so far, largest first. Gaps of up to 1 m are bridged, and of up to 0.3
  /// m on level surfaces above the ground: two tables are two planes. A smaller `min_area_m2`
  /// returns small patches, too.
  std::vector<TruthPlane> planes(double min_area_m2 = 0.5) const;

  /// Returns all cells that were hit, also of faces too small for a plane, in no particular order.
  std::vector<TruthCell> cells() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ribbon_mapper::sim
