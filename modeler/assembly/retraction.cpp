// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/retraction.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "modeler/assembly/box_index.hpp"
#include "modeler/geometry/angles.hpp"
#include "modeler/geometry/grid_keys.hpp"

namespace ribbon_mapper {
namespace {

/// Smallest angle between a beam and a plane that it passes: flatter ones do not tell where.
constexpr double kMinAngle_deg = 10.0;

/// Part of a plane's cells that, once passed, takes all of the plane with it.
constexpr double kWholeShare = 0.5;

/// Number of ribbons that are handled together: those of about a second, which lie close together.
constexpr std::size_t kChunk = 250;

/// The beams of a ribbon in map.
struct Beams {
  Beams(const Ribbon& source, const Pose& T_map_base, const Eigen::Vector3f& sensor_base)
      : ribbon(source, T_map_base),
        sensor(T_map_base * sensor_base.cast<double>()),
        first(ribbon.point(source.samples.start_m, 0.0F)),
        last(ribbon.point(source.samples.start_m + source.samples.length_m(), 0.0F)) {}
  std::uint32_t line() const { return ribbon.ribbon->pose; }

  PosedSamples ribbon;
  Eigen::Vector3d sensor, first, last;
};

/// The cells of a plane with what the lines say of each.
class PassedCells {
 public:
  PassedCells(const Plane& plane, const AssemblyConfig& config)
      : plane_(&plane),
        beyond_m_(config.passed_beyond_m),
        min_sine_(std::sin(kMinAngle_deg * kDegree)),
        min_passes_(static_cast<std::uint32_t>(config.passed_lines)),
        bounds_(bounds_of_cells(plane)),
        cells_(static_cast<std::size_t>(bounds_.u_end - bounds_.u_begin) *
               static_cast<std::size_t>(bounds_.v_end - bounds_.v_begin)) {}

  /// Counts the points of a line on the plane.
  void hit(const Beams& beams) {
    const Eigen::Vector2f centroid = grid_place(beams.ribbon.centroid).cast<float>();
    const Eigen::Vector2f along =
        (grid_place(beams.ribbon.centroid + beams.ribbon.along) - grid_place(beams.ribbon.centroid))
            .cast<float>();
    beams.ribbon.samples().for_each([&](float along_m, float, std::uint32_t) {
      Cell* const cell = cell_at(Eigen::Vector2f(centroid + along_m * along));
      if (cell != nullptr) *cell = {beams.line(), 0, true};
    });
  }

  /// Counts the beams of a line that end behind the plane.
  void pass(const Beams& beams) {
    const double from_m = distance_m(beams.sensor), side = from_m > 0.0 ? 1.0 : -1.0;
    if (side * from_m < beyond_m_) return;
    const double first_m = side * distance_m(beams.first) + beyond_m_;
    const double last_m = side * distance_m(beams.last) + beyond_m_;
    if (first_m > 0.0 && last_m > 0.0) return;
    // The part of the ribbon that lies far enough behind the plane.
    const double border = first_m / (first_m - last_m);
    const Eigen::Vector3d way = beams.last - beams.first;
    const Eigen::Vector3d a = first_m > 0.0 ? beams.first + border * way : beams.first;
    const Eigen::Vector3d b = last_m > 0.0 ? beams.first + border * way : beams.last;
    if (sine(beams.sensor, a) < min_sine_ || sine(beams.sensor, b) < min_sine_) return;
    count_way(grid_place(crossing(beams.sensor, a)), grid_place(crossing(beams.sensor, b)),
              beams.line());
  }

  /// Returns the plane's cells that are left. Only passed areas of three by three cells go.
  std::vector<PlaneCell> remaining() {
    mark_areas();
    std::vector<PlaneCell> result;
    for (const PlaneCell& cell : plane_->cells) {
      if (!cells_[index(cell.u, cell.v)].is_gone) result.push_back(cell);
    }
    return result;
  }

 private:
  static constexpr std::uint32_t kNoLine = ~std::uint32_t{0};
  struct Cell {
    std::uint32_t line = kNoLine;  // the last one that ended here or passed
    std::uint32_t passes = 0;      // lines that passed since the last one that ended here
    bool was_hit = false, is_gone = false;
  };

  std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v - bounds_.v_begin) *
               static_cast<std::size_t>(bounds_.u_end - bounds_.u_begin) +
           static_cast<std::size_t>(u - bounds_.u_begin);
  }
  bool holds(int u, int v) const {
    return u >= bounds_.u_begin && u < bounds_.u_end && v >= bounds_.v_begin && v < bounds_.v_end;
  }
  double distance_m(const Eigen::Vector3d& point) const {
    return plane_->normal.dot(point) + plane_->d_m;
  }
  double sine(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    return std::abs(plane_->normal.dot(to - from)) / (to - from).norm();
  }
  Eigen::Vector3d crossing(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    const double before = distance_m(from), after = distance_m(to);
    return from + before / (before - after) * (to - from);
  }
  Eigen::Vector2d grid_place(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d offset = point - plane_->origin;
    return Eigen::Vector2d(offset.dot(plane_->axis_u), offset.dot(plane_->axis_v)) /
           plane_->cell_size_m;
  }
  template <typename Place>
  Cell* cell_at(const Place& place) {
    const int u = floor_to_int(place.x()), v = floor_to_int(place.y());
    return holds(u, v) ? &cells_[index(u, v)] : nullptr;
  }
  void count_way(const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::uint32_t line) {
    const Eigen::Vector2d low = from.cwiseMin(to), high = from.cwiseMax(to);
    if (high.x() < bounds_.u_begin || low.x() >= bounds_.u_end || high.y() < bounds_.v_begin ||
        low.y() >= bounds_.v_end)
      return;
    const Eigen::Vector2d way = to - from;
    const int steps = std::max(1, floor_to_int(2.0 * way.cwiseAbs().maxCoeff()));
    for (int i = 0; i <= steps; ++i) {
      Cell* const cell = cell_at(from + static_cast<double>(i) / steps * way);
      if (cell == nullptr || cell->line == line) continue;  // what ends here comes first
      cell->line = line;
      ++cell->passes;
    }
  }
  bool is_passed(int u, int v) const {
    const Cell& cell = cells_[index(u, v)];
    return cell.was_hit && cell.passes >= min_passes_;
  }
  template <typename Function>
  static void for_each_of_block(int u, int v, const Function& function) {
    for (int i = 0; i < 9; ++i) function(u + i % 3 - 1, v + i / 3 - 1);
  }
  void mark_areas() {
    for (int v = bounds_.v_begin + 1; v < bounds_.v_end - 1; ++v) {
      for (int u = bounds_.u_begin + 1; u < bounds_.u_end - 1; ++u) {
        bool all = true;
        for_each_of_block(u, v, [&](int a, int b) { all = all && is_passed(a, b); });
        if (!all) continue;
        for_each_of_block(u, v, [&](int a, int b) { cells_[index(a, b)].is_gone = true; });
      }
    }
  }

  const Plane* plane_;
  double beyond_m_, min_sine_;
  std::uint32_t min_passes_;
  CellRectangle bounds_;
  std::vector<Cell> cells_;
};

/// Counts what the lines say of the cells, in the order of time.
class Counting {
 public:
  Counting(const std::vector<Plane>& planes, const PosedObservations& observations,
           const AssemblyConfig& config)
      : observations_(observations),
        plane_of_(planes_by_ribbon(observations.ribbon_count(), planes)),
        index_(boxes_of_cells(planes)) {
    for (const Plane& plane : planes) cells_.emplace_back(plane, config);
  }

  /// Counts all lines and moves the cells out.
  std::vector<PassedCells> result() {
    const std::size_t count = observations_.ribbon_count();
    for (std::size_t begin = 0; begin < count; begin += kChunk) {
      add(begin, std::min(begin + kChunk, count));
    }
    return std::move(cells_);
  }

 private:
  void add(std::size_t begin, std::size_t end) {
    std::vector<Beams> chunk;
    chunk.reserve(end - begin);
    Eigen::AlignedBox3d reach;
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t line = observations_.source(i).pose;
      const Pose T_map_base = observations_.T_map_model() * observations_.T_model_base(line);
      chunk.emplace_back(observations_.source(i), T_map_base,
                         observations_.unassigned()[line].sensor);
      reach.extend(chunk.back().sensor).extend(chunk.back().first).extend(chunk.back().last);
    }
    for (const std::size_t plane : index_.near(reach, 0.0)) {
      for (std::size_t i = begin; i < end; ++i) {
        if (plane_of_[i] == static_cast<std::int32_t>(plane)) {
          cells_[plane].hit(chunk[i - begin]);
        } else {
          cells_[plane].pass(chunk[i - begin]);
        }
      }
    }
  }

  const PosedObservations& observations_;
  std::vector<std::int32_t> plane_of_;
  std::vector<PassedCells> cells_;  // by plane
  BoxIndex index_;                  // of the planes
};

/// Takes the cells of a plane that are not among those that remain. Returns whether the plane does.
bool take_cells(Plane& plane, std::vector<PlaneCell> remaining, double min_area_m2) {
  const double before = static_cast<double>(plane.cells.size());
  const double left = static_cast<double>(remaining.size());
  if (remaining.size() == plane.cells.size()) return true;
  if (before - left >= kWholeShare * before) return false;
  plane.cells = std::move(remaining);
  plane.area_m2 = static_cast<double>(plane.cells.size()) * plane.cell_size_m * plane.cell_size_m;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const PlaneCell& cell : plane.cells) sum += cell_centre(plane, cell);
  plane.centroid = sum / static_cast<double>(plane.cells.size());
  return plane.area_m2 >= min_area_m2;
}

}  // namespace

PlaneModel without_passed_cells(std::vector<Plane> planes, const PosedObservations& observations,
                                const AssemblyConfig& config) {
  std::vector<PassedCells> counts = Counting(planes, observations, config).result();
  PlaneModel model;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    Plane& plane = planes[i];
    if (take_cells(plane, counts[i].remaining(), config.min_area_m2)) {
      model.planes.push_back(std::move(plane));
    } else {
      model.gone_ribbons.insert(model.gone_ribbons.end(), plane.ribbons.begin(),
                                plane.ribbons.end());
    }
  }
  std::sort(model.gone_ribbons.begin(), model.gone_ribbons.end());
  return model;
}

}  // namespace ribbon_mapper
