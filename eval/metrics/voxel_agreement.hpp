// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "eval/metrics/true_voxels.hpp"
#include "modeler/maps/navigation_map.hpp"
#include "modeler/maps/voxel_map.hpp"

namespace ribbon_mapper::eval {

/// How a map of voxels agrees with the world and with the beams that passed it.
struct VoxelAgreement {
  std::size_t occupied = 0;          ///< occupied voxels
  std::size_t occupied_near = 0;     ///< of these: within one voxel of a true surface
  std::size_t free = 0;              ///< free voxels
  std::size_t free_on_surface = 0;   ///< of these: a surface passes their middle
  std::size_t free_not_passed = 0;   ///< of these: no beam passed them or a neighbour
  std::size_t truly_free = 0;        ///< voxels that a beam passed and no surface touches
  std::size_t truly_free_found = 0;  ///< of these: free in the map

  /// Returns the part of the occupied voxels that are near a surface.
  double occupied_right() const;
  /// Returns the part of the free voxels that hold no surface and that beams passed.
  double free_right() const;
  /// Returns the part of the truly free voxels that are free in the map.
  double free_found() const;
};

/// Compares a map, whose origin is that of map, with the truth.
VoxelAgreement agreement_of(const VoxelMap& map, const TrueVoxels& truth);

/// How a level map agrees with the world's cut.
struct LevelAgreement {
  std::size_t free = 0;            ///< free cells
  std::size_t free_right = 0;      ///< of these: no surface passes the middle of their voxels
  std::size_t occupied = 0;        ///< occupied cells
  std::size_t occupied_right = 0;  ///< of these: a surface in the cell or one of its 8 neighbours

  /// Returns the part of the known cells that are right.
  double right() const;
};

/// Compares a level map with the surfaces between two heights in map [m].
LevelAgreement agreement_of(const NavigationMap& map, const TrueVoxels& truth, double from_m,
                            double to_m);

}  // namespace ribbon_mapper::eval
