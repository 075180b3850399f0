// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "sim/world/world.hpp"

namespace ribbon_mapper::sim {

/// The edges of each face of a world: where its surface ends or bends. An edge between two coplanar
/// triangles of one face, such as the diagonal of a box's side, is none.
class FaceEdges {
 public:
  /// Finds the edges of all faces of `world`.
  explicit FaceEdges(const World& world);

  /// Returns the distance from `point_map` to the nearest edge of `face` [m].
  double distance_m(const Eigen::Vector3d& point_map, int face) const;

 private:
  struct Segment {
    Eigen::Vector3d from, to;
  };
  std::vector<std::vector<Segment>> edges_;  ///< by face
};

}  // namespace ribbon_mapper::sim
