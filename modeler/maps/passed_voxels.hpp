// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "modeler/maps/voxel_grid.hpp"

namespace ribbon_mapper {

/// Visits the voxels of a triangle whose plane leaves an axis most directly: `up`, 0 to 2.
template <std::size_t up, typename Function>
class TriangleVoxels {
 public:
  /// Prepares the visit of one triangle, in units of voxels, with its normal of any length.
  TriangleVoxels(const std::array<Eigen::Vector3f, 3>& corners, const Eigen::Vector3f& normal,
                 const Function& function)
      : function_(function),
        slope_column_(-normal[kColumn] / normal[kUp]),
        slope_row_(-normal[kRow] / normal[kUp]),
        height_(corners[0][kUp] - slope_column_ * corners[0][kColumn] -
                slope_row_ * corners[0][kRow]),
        thickness_(0.5F * (std::abs(slope_column_) + std::abs(slope_row_))) {
    for (std::size_t i = 0; i < 3; ++i) corners_[i] = {corners[i][kColumn], corners[i][kRow]};
    const auto sort = [this](std::size_t a, std::size_t b) {
      if (corners_[b].y() < corners_[a].y()) std::swap(corners_[a], corners_[b]);
    };
    sort(0, 1), sort(1, 2), sort(0, 1);
  }

  /// Visits row by row.
  void visit() const {
    const std::int32_t end = first_centre(corners_[2].y());
    for (std::int32_t row = first_centre(corners_[0].y()); row < end; ++row) {
      const float y = static_cast<float>(row) + 0.5F;
      const float a = column_at(y, corners_[0], corners_[2]);
      const float b = y < corners_[1].y() ? column_at(y, corners_[0], corners_[1])
                                          : column_at(y, corners_[1], corners_[2]);
      visit_row(row, first_centre(std::min(a, b)), first_centre(std::max(a, b)));
    }
  }

 private:
  static constexpr auto kUp = static_cast<Eigen::Index>(up);
  static constexpr auto kColumn = static_cast<Eigen::Index>((up + 1) % 3);
  static constexpr auto kRow = static_cast<Eigen::Index>((up + 2) % 3);

  /// Returns the first voxel whose centre is not below `x`.
  static std::int32_t first_centre(float x) { return -floor_to_int(0.5F - x); }

  static float column_at(float y, const Eigen::Vector2f& from, const Eigen::Vector2f& to) {
    const float rows = to.y() - from.y();
    return rows > 0.0F ? from.x() + (y - from.y()) * (to.x() - from.x()) / rows : from.x();
  }

  void visit_row(std::int32_t row, std::int32_t begin, std::int32_t end) const {
    const float at_row = height_ + slope_row_ * (static_cast<float>(row) + 0.5F);
    MapVoxel voxel{};
    voxel[(up + 2) % 3] = row;
    for (std::int32_t column = begin; column < end; ++column) {
      const float height = at_row + slope_column_ * (static_cast<float>(column) + 0.5F);
      const std::int32_t last = floor_to_int(height + thickness_);
      voxel[(up + 1) % 3] = column;
      for (voxel[up] = floor_to_int(height - thickness_); voxel[up] <= last; ++voxel[up]) {
        function_(voxel);
      }
    }
  }

  const Function& function_;
  float slope_column_, slope_row_, height_, thickness_;
  std::array<Eigen::Vector2f, 3> corners_;  // by rows
};

/// Calls function(voxel) for the voxels that a triangle crosses, given in units of voxels.
///
/// Of each column of voxels along the axis nearest to the normal, those are visited that the
/// triangle's plane crosses, if the triangle covers the middle of the column.
template <typename Function>
void for_each_voxel_of_triangle(const std::array<Eigen::Vector3f, 3>& corners,
                                const Function& function) {
  const Eigen::Vector3f normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  Eigen::Index up = 0;
  if (!(normal.cwiseAbs().maxCoeff(&up) > 1e-6F)) return;
  if (up == 0) TriangleVoxels<0, Function>(corners, normal, function).visit();
  if (up == 1) TriangleVoxels<1, Function>(corners, normal, function).visit();
  if (up == 2) TriangleVoxels<2, Function>(corners, normal, function).visit();
}

/// Calls function(voxel) for voxels along a straight way, given in units of voxels: one for each
/// step along the axis that it follows most.
template <typename Function>
void for_each_voxel_of_way(const Eigen::Vector3f& from, const Eigen::Vector3f& to,
                           const Function& function) {
  const Eigen::Vector3f way = to - from;
  const float steps = std::ceil(way.cwiseAbs().maxCoeff());
  if (!(steps >= 1.0F)) return;
  const Eigen::Vector3f step = way / steps;
  const auto count = static_cast<std::int32_t>(steps);
  for (std::int32_t i = 0; i < count; ++i) {
    function(voxel_at(from + (static_cast<float>(i) + 0.5F) * step));
  }
}

}  // namespace ribbon_mapper
