// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/spurious_planes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "modeler/assembly/box_index.hpp"
#include "modeler/geometry/angles.hpp"
#include "modeler/surface/footprint.hpp"

namespace ribbon_mapper {
namespace {

/// The cells of a plane by rows, with the mean distances of their points from it.
class MeasuredCells {
 public:
  /// Refers to the cells of a plane, which must outlive it.
  explicit MeasuredCells(const Plane& plane) : plane_(&plane) {
    if (plane.cells.empty()) return;
    const PlaneCell* const end = plane.cells.data() + plane.cells.size();
    for (const PlaneCell *row = plane.cells.data(), *next = row; row != end; row = next) {
      for (; next != end && next->v == row->v; ++next) {
        max_m_ = std::max(max_m_, std::abs(next->mean_m));
      }
      rows_.push_back({row, next});
    }
    const Eigen::AlignedBox3d on_plane = box_of_cells(plane);
    const Eigen::Vector3d above = (max_m_ * plane.normal).cwiseAbs();
    box_ = {on_plane.min() - above, on_plane.max() + above};
  }

  /// Returns the plane.
  const Plane& plane() const { return *plane_; }
  /// Returns a box around the mean points of all cells.
  const Eigen::AlignedBox3d& box() const { return box_; }

  /// Calls function(index, point) for each cell whose mean point lies within `reach_m` of another
  /// plane. Along a row, the distance of the cells from that plane is linear.
  template <typename Function>
  void for_each_near(const Plane& other, double reach_m, const Function& function) const {
    const double slope = plane_->cell_size_m * other.normal.dot(plane_->axis_u);
    const double steepness = std::max(1e-9, std::abs(slope));
    const double slack_m = reach_m + max_m_ * std::abs(other.normal.dot(plane_->normal));
    const double half = slack_m / steepness + 1.0;
    for (const Row& row : rows_) {
      const Eigen::Vector3d start = cell_centre(*plane_, {0, row.begin->v});
      const double middle =
          -(other.normal.dot(start) + other.d_m) / std::copysign(steepness, slope);
      const PlaneCell* cell = std::lower_bound(
          row.begin, row.end, middle - half, [](const PlaneCell& a, double u) { return a.u < u; });
      for (; cell != row.end && cell->u <= middle + half; ++cell) {
        const Eigen::Vector3d point = cell_centre(*plane_, *cell) + cell->mean_m * plane_->normal;
        if (std::abs(other.normal.dot(point) + other.d_m) > reach_m) continue;
        function(static_cast<std::size_t>(cell - plane_->cells.data()), point);
      }
    }
  }

 private:
  struct Row {
    const PlaneCell *begin, *end;
  };

  const Plane* plane_;
  float max_m_ = 0.0F;
  std::vector<Row> rows_;
  Eigen::AlignedBox3d box_;
};

/// A plane that the points of smaller, spurious planes may lie on.
class SupportingPlane {
 public:
  /// Refers to a plane, which must outlive it.
  SupportingPlane(const Plane& plane, const AssociationGates& gates, double bridged_gap_m,
                  const AssemblyConfig& config)
      : plane_(&plane),
        min_cosine_(std::cos(gates.angle_deg * kDegree)),
        cell_gate_m_(std::min(config.on_plane_m, 0.5 * gates.distance_m)),
        bridged_gap_m_(bridged_gap_m),
        config_(&config) {}

  /// Marks the cells of `other` whose mean points lie on this plane.
  void mark_supported(const MeasuredCells& other, std::vector<bool>& supported) {
    const double cosine = plane_->normal.dot(other.plane().normal);
    if (cosine <= 0.0) return;  // the sides of a thin wall are different planes
    const bool is_nearly_parallel = cosine > kMinCosineOfParallel;
    const bool is_tilted = is_nearly_parallel && cosine < min_cosine_;
    const double reach_m = is_tilted ? cell_gate_m_ : config_->on_plane_m;
    other.for_each_near(*plane_, reach_m, [&](std::size_t i, const auto& point) {
      if (supported[i]) return;
      const Footprint& around = is_nearly_parallel ? footprint(beyond_gap_, 0.5 * bridged_gap_m_)
                                                   : footprint(beside_, config_->beside_plane_m);
      supported[i] = around.holds(point, config_->on_plane_m);
    });
  }

 private:
  static constexpr double kMinCosineOfParallel = 0.985;  // 10 degrees

  /// Returns the footprint, which is created when it is first needed.
  const Footprint& footprint(std::optional<Footprint>& made, double reach_m) {
    if (!made) made.emplace(*plane_, reach_m);
    return *made;
  }

  const Plane* plane_;
  double min_cosine_;   // of a plane that the gate of the angle takes for parallel
  double cell_gate_m_;  // of a plane that is tilted by more
  double bridged_gap_m_;
  const AssemblyConfig* config_;
  std::optional<Footprint> beside_, beyond_gap_;
};

/// Returns the indices of the planes, the largest first.
std::vector<std::size_t> by_size(const std::vector<const Plane*>& planes) {
  std::vector<std::size_t> order(planes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return planes[a]->area_m2 > planes[b]->area_m2;
  });
  return order;
}

}  // namespace

std::vector<bool> are_spurious(const std::vector<const Plane*>& planes,
                               const AssociationGates& gates, double bridged_gap_m,
                               const AssemblyConfig& config) {
  std::vector<MeasuredCells> measured;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Plane* plane : planes) {
    measured.emplace_back(*plane);
    boxes.push_back(measured.back().box());
  }
  const BoxIndex index(boxes);
  const double reach_m = bridged_gap_m + config.on_plane_m;  // twice the wider reach
  std::vector<bool> spurious(planes.size());
  std::vector<std::optional<SupportingPlane>> larger(planes.size());
  for (const std::size_t i : by_size(planes)) {
    const std::size_t cells = planes[i]->cells.size();
    std::vector<bool> supported(cells, false);
    for (const std::size_t near : index.near(boxes[i], reach_m)) {
      if (larger[near]) larger[near]->mark_supported(measured[i], supported);
    }
    const auto count = std::count(supported.begin(), supported.end(), true);
    spurious[i] = 2 * static_cast<std::size_t>(count) > cells;
    if (!spurious[i]) larger[i].emplace(*planes[i], gates, bridged_gap_m, config);
  }
  return spurious;
}

std::vector<Plane> without_spurious_planes(std::vector<Plane> planes, const AssociationGates& gates,
                                           double bridged_gap_m, const AssemblyConfig& config) {
  std::stable_sort(planes.begin(), planes.end(),
                   [](const Plane& a, const Plane& b) { return a.area_m2 > b.area_m2; });
  std::vector<const Plane*> pointers;
  for (const Plane& plane : planes) pointers.push_back(&plane);
  const std::vector<bool> spurious = are_spurious(pointers, gates, bridged_gap_m, config);
  std::vector<Plane> kept;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (!spurious[i]) kept.push_back(std::move(planes[i]));
  }
  return kept;
}

}  // namespace ribbon_mapper
