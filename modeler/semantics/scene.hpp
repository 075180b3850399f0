// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "modeler/semantics/label.hpp"
#include "modeler/semantics/plane_shape.hpp"
#include "modeler/semantics/top_view.hpp"

namespace ribbon_mapper {

/// Planes with their shapes, and what the rules ask about their places.
class Scene {
 public:
  /// Prepares planes, which must outlive the scene. `driven` are positions of the robot's footprint
  /// in map [m]; there may be none.
  Scene(const std::vector<Plane>& planes, const std::vector<Eigen::Vector3d>& driven,
        const LabelConfig& config);

  /// Returns the planes.
  const std::vector<Plane>& planes() const { return planes_; }
  /// Returns the shape of a plane.
  const PlaneShape& shape(std::size_t plane) const { return shapes_[plane]; }
  /// Returns the limits.
  const LabelConfig& config() const { return config_; }

  /// Returns true if the robot has driven on the plane.
  bool is_driven(std::size_t plane) const { return driven_[plane]; }
  /// Returns the floor that was driven on most, or the largest level plane if none was. Nothing if
  /// no plane is level.
  std::optional<std::size_t> main_floor() const { return main_floor_; }
  /// Returns true if the plane is a floor.
  bool is_floor(std::size_t plane) const { return floor_[plane]; }

  /// Returns the height of the floor below a point [m].
  double floor_height_m(const Eigen::Vector3d& point) const;
  /// Returns the height of the lowest ceiling or roof above a place that is higher than `from_m`.
  std::optional<double> ceiling_height_m(const Eigen::Vector2d& place, double from_m) const;
  /// Returns the centres of all cells of floors and ramps within a square of `reach_m` or more
  /// around a place.
  std::vector<Eigen::Vector3d> floor_cells_around(const Eigen::Vector2d& place,
                                                  double reach_m) const;
  /// Returns true if the robot has driven within `reach_m` of a place at this height.
  bool is_driven_at(const Eigen::Vector2d& place, double height_m, double reach_m) const;

  /// Returns the upright planes in the squares within `reach_m` of a place, in ascending order.
  std::vector<std::size_t> upright_around(const Eigen::Vector2d& place, double reach_m) const;

  /// Returns the share of an upright plane's columns behind which a plane of the same side rises
  /// higher: a wall behind furniture.
  double backed_share(std::size_t plane) const;

 private:
  void add(std::size_t plane, TopView<PlanePart>& view) const;
  void find_driven(const std::vector<Eigen::Vector3d>& driven);
  void find_floors();
  void find_ceilings();
  bool is_backed(std::size_t plane, const Column& column) const;

  const std::vector<Plane>& planes_;
  LabelConfig config_;
  std::vector<PlaneShape> shapes_;
  std::vector<bool> driven_, floor_;
  std::vector<std::size_t> footprints_;
  std::optional<std::size_t> main_floor_;
  TopView<PlanePart> upward_{kSquare_m}, floors_{kSquare_m}, overhead_{kSquare_m},
      upright_{kSquare_m};
  TopView<Eigen::Vector3d> floor_cells_{kSquare_m}, footprints_seen_{kSquare_m};

  static constexpr double kSquare_m = 0.25;  // a robot's radius, a wall's thickness
};

}  // namespace ribbon_mapper
