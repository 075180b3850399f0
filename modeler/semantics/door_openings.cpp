// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/semantics/door_openings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ribbon_mapper {
namespace {

constexpr double kBandBegin_m = 0.2, kBandEnd_m = 1.8;  // above skirting boards, below lintels
constexpr double kOpenShare = 0.2;     // of a column's cells that an open one may still have
constexpr double kReach_m = 0.15;      // of the floor before a wall and in it
constexpr double kThroughShare = 0.6;  // of an opening's columns through which the floor goes on

/// Walls in one plane.
using WallGroup = std::vector<std::size_t>;

/// The columns of walls in one plane, one for each cell along them, those without cells among them.
class WallColumns {
 public:
  WallColumns(const WallGroup& walls, const Scene& scene)
      : scene_(scene), plane_(scene.planes()[walls.front()]), shape_(scene.shape(walls.front())) {
    std::vector<std::pair<double, const Column*>> columns;
    for (const std::size_t wall : walls) {
      for (const Column& column : scene.shape(wall).columns) {
        columns.emplace_back(shape_.along.dot(column.place), &column);
      }
    }
    const auto [first, last] = std::minmax_element(columns.begin(), columns.end());
    begin_m_ = first->first - 0.5 * plane_.cell_size_m;
    columns_.resize(index_of(last->first) + 1);
    for (const auto& [along_m, column] : columns) columns_[index_of(along_m)].push_back(column);
    floor_m_ = scene.floor_height_m({plane_.centroid.x(), plane_.centroid.y(), shape_.highest_m});
  }

  std::size_t size() const { return columns_.size(); }

  bool is_open(std::size_t i) const {
    std::ptrdiff_t in_band = 0;
    for (const Column* column : columns_[i]) {
      in_band += std::count_if(column->heights_m.begin(), column->heights_m.end(), [&](double z_m) {
        return z_m > floor_m_ + kBandBegin_m && z_m < floor_m_ + kBandEnd_m;
      });
    }
    return static_cast<double>(in_band) * plane_.cell_size_m <=
           kOpenShare * (kBandEnd_m - kBandBegin_m);
  }

  /// Returns the height of the lintel in a column.
  std::optional<double> lintel_m(std::size_t i) const {
    for (const Column* column : columns_[i]) {
      for (const double z_m : column->heights_m) {
        if (z_m >= floor_m_ + kBandEnd_m) return z_m - 0.5 * plane_.cell_size_m;
      }
    }
    return std::nullopt;
  }

  /// Returns true if the floor was seen before the wall and inside it. The cells of a floor that
  /// ends at the wall reach into it by half a cell.
  bool is_passable(std::size_t i) const {
    const Eigen::Vector3d at = place(static_cast<double>(i) + 0.5);
    const Eigen::Vector2d across = plane_.normal.head<2>().normalized();
    const double half_m = 0.5 * plane_.cell_size_m;
    bool has_front = false, has_inside = false;
    for (const Eigen::Vector3d& cell : scene_.floor_cells_around(at.head<2>(), kReach_m)) {
      const Eigen::Vector2d from = cell.head<2>() - at.head<2>();
      if (std::abs(from.dot(shape_.along)) > 2.0 * half_m) continue;
      const double depth_m = -from.dot(across) / half_m;  // in half cells
      has_front = has_front || (depth_m < -1.0 && depth_m > -5.0);
      has_inside = has_inside || (depth_m >= 1.2 && depth_m <= 3.2);
    }
    return has_front && has_inside;
  }

  /// Returns the place on the wall's foot, `cells` along it.
  Eigen::Vector3d place(double cells) const {
    const double along_m = begin_m_ + cells * plane_.cell_size_m;
    const Eigen::Vector2d across = plane_.normal.head<2>().normalized();
    const double level = plane_.normal.head<2>().norm();
    const double distance_m = -(plane_.d_m + plane_.normal.z() * floor_m_) / level;
    const Eigen::Vector2d xy = distance_m * across + along_m * shape_.along;
    return {xy.x(), xy.y(), floor_m_};
  }

  /// Returns true if the robot has driven through columns [begin, end).
  bool is_driven_through(std::size_t begin, std::size_t end) const {
    const Eigen::Vector3d middle = place(0.5 * static_cast<double>(begin + end));
    return scene_.is_driven_at(middle.head<2>(), floor_m_,
                               0.5 * static_cast<double>(end - begin) * plane_.cell_size_m);
  }

  /// Returns true if the wall goes on for `least_m` on both sides of columns [begin, end).
  bool is_flanked(std::size_t begin, std::size_t end, double least_m) const {
    const auto least = static_cast<std::size_t>(std::ceil(least_m / plane_.cell_size_m));
    if (begin < least || end + least > size()) return false;
    for (std::size_t i = 1; i <= least; ++i) {
      if (is_open(begin - i) || is_open(end + i - 1)) return false;
    }
    return true;
  }

  double floor_m() const { return floor_m_; }
  const Plane& plane() const { return plane_; }

 private:
  std::size_t index_of(double along_m) const {
    return static_cast<std::size_t>((along_m - begin_m_) / plane_.cell_size_m);
  }

  const Scene& scene_;
  const Plane& plane_;
  const PlaneShape& shape_;
  std::vector<std::vector<const Column*>> columns_;
  double begin_m_ = 0.0, floor_m_ = 0.0;
};

/// Returns the opening of columns [begin, end), if it is one of a door.
std::optional<DoorOpening> opening_of(const WallColumns& wall, std::size_t begin, std::size_t end,
                                      const LabelConfig& config) {
  const double width_m = static_cast<double>(end - begin) * wall.plane().cell_size_m;
  if (width_m < config.least_door_width_m || width_m > config.greatest_door_width_m) return {};
  std::size_t passable = 0;
  std::vector<double> lintels;
  for (std::size_t i = begin; i < end; ++i) {
    passable += wall.is_passable(i) ? 1 : 0;
    if (const auto lintel_m = wall.lintel_m(i)) lintels.push_back(*lintel_m);
  }
  const bool has_head = 2 * lintels.size() >= end - begin;
  const double through = static_cast<double>(passable) / static_cast<double>(end - begin);
  const bool has_flanks = wall.is_flanked(begin, end, config.least_flank_m);
  if (!has_head && !(has_flanks && wall.is_driven_through(begin, end))) return {};
  DoorOpening opening;
  opening.plane = wall.plane().id;
  opening.jambs[0] = wall.place(static_cast<double>(begin) - 0.5);
  opening.jambs[1] = wall.place(static_cast<double>(end) + 0.5);
  opening.sill_m = wall.floor_m();
  opening.is_passable = through >= kThroughShare;
  if (has_head) opening.head_m = value_at(lintels, 0.5);
  opening.confidence =
      std::min({certainty(width_m - config.least_door_width_m, config.size_sigma_m),
                certainty(config.greatest_door_width_m - width_m, config.size_sigma_m),
                certainty(through - kThroughShare, 0.2)});
  return opening;
}

void add_openings_in(const WallColumns& wall, const LabelConfig& config,
                     std::vector<DoorOpening>& openings) {
  for (std::size_t begin = 0; begin < wall.size(); ++begin) {
    if (!wall.is_open(begin)) continue;
    std::size_t end = begin;
    while (end < wall.size() && wall.is_open(end)) ++end;
    if (const auto opening = opening_of(wall, begin, end, config)) openings.push_back(*opening);
    begin = end;
  }
}

bool are_coplanar(const Plane& a, const Plane& b) {
  constexpr double kCosine = 0.9994;  // 2 degrees
  return a.normal.dot(b.normal) >= kCosine &&
         std::abs(a.normal.dot(b.centroid) + a.d_m) <= a.cell_size_m &&
         std::abs(b.normal.dot(a.centroid) + b.d_m) <= a.cell_size_m;
}

/// Returns the walls in the plane of a wall that follow it, as far as the width of a door.
WallGroup neighbours_of(std::size_t wall, const std::vector<bool>& is_wall, const Scene& scene) {
  WallGroup neighbours;
  const std::vector<Column>& columns = scene.shape(wall).columns;
  for (const Column* end : {&columns.front(), &columns.back()}) {
    for (const std::size_t other :
         scene.upright_around(end->place, scene.config().greatest_door_width_m)) {
      if (other != wall && is_wall[other] &&
          are_coplanar(scene.planes()[wall], scene.planes()[other])) {
        neighbours.push_back(other);
      }
    }
  }
  return neighbours;
}

/// Returns each wall once, together with those in its plane that follow it and each other.
std::vector<WallGroup> groups_of(const std::vector<bool>& is_wall, const Scene& scene) {
  std::vector<bool> is_taken(is_wall.size());
  std::vector<WallGroup> groups;
  for (std::size_t i = 0; i < is_wall.size(); ++i) {
    if (!is_wall[i] || is_taken[i]) continue;
    WallGroup& group = groups.emplace_back(WallGroup{i});
    is_taken[i] = true;
    for (std::size_t k = 0; k < group.size(); ++k) {
      for (const std::size_t other : neighbours_of(group[k], is_wall, scene)) {
        if (!is_taken[other]) group.push_back(other);
        is_taken[other] = true;
      }
    }
  }
  return groups;
}

}  // namespace

std::vector<DoorOpening> door_openings_in(const std::vector<bool>& is_wall, const Scene& scene) {
  std::vector<DoorOpening> openings;
  for (const WallGroup& group : groups_of(is_wall, scene)) {
    add_openings_in(WallColumns(group, scene), scene.config(), openings);
  }
  return openings;
}

}  // namespace ribbon_mapper
