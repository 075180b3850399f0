// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "modeler/maps/voxel_grid.hpp"
#include "sim/robot/hokuyo.hpp"
#include "sim/shapes/tessellation.hpp"

namespace ribbon_mapper::eval {

/// Returns true if a triangle touches a box (Akenine-Moeller 2001: separating axes).
bool touches(const std::array<Eigen::Vector3d, 3>& corners_m, const Eigen::AlignedBox3d& box);

/// Where the surfaces of a world are and where beams truly passed, by voxels whose first corner is
/// the origin of map.
class TrueVoxels {
 public:
  /// Prepares voxels of a side [m].
  explicit TrueVoxels(double voxel_m) : voxel_m_(voxel_m) {}

  /// Adds the surfaces of triangles within a box [m].
  void add_surfaces(const std::vector<sim::Triangle>& triangles, const Eigen::AlignedBox3d& box);
  /// Adds the way of each beam up to the surface that it truly hit. Beams without a return add
  /// nothing.
  void add_beams(const sim::Scan& scan);

  /// Returns true if a surface touches the voxel.
  bool touches_surface(const MapVoxel& voxel) const { return (grid_[voxel] & kTouched) != 0; }
  /// Returns true if a surface passes the middle half of the voxel, along each axis.
  bool holds_surface(const MapVoxel& voxel) const { return (grid_[voxel] & kHeld) != 0; }
  /// Returns true if a beam passed the voxel.
  bool was_passed(const MapVoxel& voxel) const { return (grid_[voxel] & kPassed) != 0; }
  /// Returns true if a beam passed the voxel or one of its 26 neighbours.
  bool was_passed_near(const MapVoxel& voxel) const { return is_near(voxel, kPassed); }
  /// Returns true if a surface touches the voxel or one of its 26 neighbours.
  bool is_near_surface(const MapVoxel& voxel) const { return is_near(voxel, kTouched); }
  /// Calls function(voxel) for each voxel that a beam passed and that no surface touches.
  template <typename Function>
  void for_each_free(const Function& function) const {
    grid_.for_each([&](const MapVoxel& voxel, std::uint8_t flags) {
      if ((flags & (kPassed | kTouched)) == kPassed) function(voxel);
    });
  }

 private:
  static constexpr unsigned kTouched = 1, kHeld = 2, kPassed = 4;
  bool is_near(const MapVoxel& voxel, unsigned flag) const;
  void add_surface(const sim::Triangle& triangle, const Eigen::AlignedBox3d& box);
  void add_way(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

  double voxel_m_;
  VoxelGrid grid_;
};

}  // namespace ribbon_mapper::eval
