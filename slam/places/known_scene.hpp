// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tsl/robin_map.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/geometry/voxel_key.hpp"
#include "slam/lines/known_planes.hpp"
#include "slam/matching/level_scan.hpp"

namespace ribbon_mapper::slam {

/// Returns a point of a wall as seen from above, with the normal of its surface.
LevelPoint seen_from_above(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

/// Returns some of the points that a ribbon was made of, at least a decimetre apart.
std::vector<Eigen::Vector3d> points_along(const PosedRibbon& ribbon);

/// The walls that some lines have seen, as far as they were seen. It answers whether other lines
/// see the same.
class KnownScene {
 public:
  /// A wall.
  struct Wall {
    Hypothesis plane;         ///< its plane, in start
    std::uint32_t last_line;  ///< the last line that has seen it
  };

  /// Finds the walls of lines at their poses.
  KnownScene(const PosedLines& lines, const std::vector<std::uint32_t>& indices,
             const EstimateSettings& settings);

  /// Returns the known wall that a ribbon lies on, within gates and where the wall was seen.
  const Wall* wall_of(const PosedRibbon& ribbon, const AssociationGates& gates) const;

  /// Returns true if a known wall stands clearly between the laser and a point that it has seen.
  bool stands_between(const Eigen::Vector3d& sensor, const Eigen::Vector3d& point) const;

  /// Returns points of the walls, seen from above.
  const LevelPoints& points() const { return points_; }

 private:
  /// A wall within a voxel, and how often it was seen there.
  struct Part {
    std::uint32_t wall;
    std::uint32_t points;
  };
  void enter(std::uint32_t wall, const PosedRibbon& ribbon);
  std::optional<std::uint32_t> wall_at(const Eigen::Vector3d& point, const PosedRibbon& ribbon,
                                       const AssociationGates& gates) const;
  std::uint32_t points_at(const Eigen::Vector3d& point, std::uint32_t wall) const;
  bool is_pierced(const Eigen::Vector3d& point, const Eigen::Vector3d& direction) const;

  std::vector<Wall> walls_;
  tsl::robin_map<VoxelKey, std::vector<Part>, KeyHash> parts_;
  LevelPoints points_;
};

}  // namespace ribbon_mapper::slam
