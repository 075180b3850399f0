// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/metrics/voxel_agreement.hpp"

#include <cmath>

namespace ribbon_mapper::eval {
namespace {

double share(std::size_t part, std::size_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 1.0;
}

/// Returns whether `is_so(voxel)` for a voxel of a column.
template <typename Predicate>
bool any_of_column(int x, int y, int z_begin, int z_end, const Predicate& is_so) {
  for (int z = z_begin; z < z_end; ++z) {
    if (is_so(MapVoxel{x, y, z})) return true;
  }
  return false;
}

}  // namespace

double VoxelAgreement::occupied_right() const { return share(occupied_near, occupied); }
double VoxelAgreement::free_right() const {
  return share(free - free_on_surface - free_not_passed, free);
}
double VoxelAgreement::free_found() const { return share(truly_free_found, truly_free); }
double LevelAgreement::right() const { return share(free_right + occupied_right, free + occupied); }

VoxelAgreement agreement_of(const VoxelMap& map, const TrueVoxels& truth) {
  VoxelAgreement result;
  map.for_each([&](const MapVoxel& voxel, VoxelState state) {
    if (state == VoxelState::occupied) {
      ++result.occupied;
      if (truth.is_near_surface(voxel)) ++result.occupied_near;
    } else {
      ++result.free;
      if (truth.holds_surface(voxel)) {
        ++result.free_on_surface;
      } else if (!truth.was_passed_near(voxel)) {
        ++result.free_not_passed;
      }
    }
  });
  truth.for_each_free([&](const MapVoxel& voxel) {
    ++result.truly_free;
    if (map[voxel] == VoxelState::free) ++result.truly_free_found;
  });
  return result;
}

LevelAgreement agreement_of(const NavigationMap& map, const TrueVoxels& truth, double from_m,
                            double to_m) {
  LevelAgreement result;
  const auto z_begin = static_cast<int>(std::lround(from_m / map.cell_m));
  const auto z_end = static_cast<int>(std::lround(to_m / map.cell_m));
  const auto x0 = static_cast<int>(std::lround(map.corner_m.x() / map.cell_m));
  const auto y0 = static_cast<int>(std::lround(map.corner_m.y() / map.cell_m));
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const int x = x0 + static_cast<int>(i % map.width), y = y0 + static_cast<int>(i / map.width);
    if (map.cells[i] == NavigationMap::kFree) {
      ++result.free;
      const auto is_held = [&](const MapVoxel& voxel) { return truth.holds_surface(voxel); };
      if (!any_of_column(x, y, z_begin, z_end, is_held)) ++result.free_right;
    } else if (map.cells[i] == NavigationMap::kOccupied) {
      ++result.occupied;
      const auto is_near = [&](const MapVoxel& voxel) { return truth.is_near_surface(voxel); };
      if (any_of_column(x, y, z_begin, z_end, is_near)) ++result.occupied_right;
    }
  }
  return result;
}

}  // namespace ribbon_mapper::eval
