// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/plane_assembly.hpp"

#include <algorithm>
#include <optional>

#include "modeler/assembly/corner_lines.hpp"
#include "modeler/assembly/pieces.hpp"
#include "modeler/assembly/point_assignment.hpp"
#include "modeler/assembly/retraction.hpp"
#include "modeler/assembly/spurious_planes.hpp"
#include "modeler/surface/curvature.hpp"
#include "modeler/surface/outline.hpp"
#include "modeler/surface/surface.hpp"

namespace ribbon_mapper {
namespace {

/// Largest distance of an outline from the line where its plane meets another: at the edge, a cell
/// may be seen in part, and the next one not at all.
constexpr double kCornerReachInCells = 2.0;

/// Returns false if a hypothesis has too few ribbons, or if the area of all its samples is less
/// than `area_m2` even if each lies in a cell of its own.
bool is_promising(double area_m2, const Hypothesis& hypothesis,
                  const PosedObservations& observations, double cell_size_m,
                  const AssemblyConfig& config) {
  if (hypothesis.members().size() < static_cast<std::size_t>(config.min_ribbons)) return false;
  double max_m2 = 0.0;
  for (const Member& member : hypothesis.members()) {
    max_m2 += observations.source(member.ribbon).samples.size * cell_size_m * cell_size_m;
    if (max_m2 >= area_m2) return true;
  }
  return false;
}

/// Returns true if the surface is significantly curved, such as a facet of a column.
bool is_curved(const Plane& plane, const AssemblyConfig& config) {
  const Curvature curvature = curvature_of(plane);
  return curvature.bend - config.curvature_sigmas * curvature.sigma > 1.0 / config.min_radius_m &&
         curvature.sagitta_m > config.flat_within_m;
}

/// Returns true if a small plane consists of adjacent objects whose faces are almost in line, such
/// as a row of chairs: its cells scatter too much.
///
/// On a real plane, four fifths of the cells lie within one standard deviation of a single ribbon
/// (half the gate), since a cell is the mean of several ribbons. Large planes may sag.
bool is_row_of_objects(const Plane& plane, const AssociationGates& gates,
                       const AssemblyConfig& config) {
  if (plane.area_m2 > 4.0 * config.min_area_m2) return false;
  return cell_scatter_m(plane).value_or(0.0) > 0.5 * gates.distance_m;
}

/// Transforms a plane from the model's frame to map.
void move(Plane& plane, const Pose& T_map_model) {
  plane.normal = T_map_model.linear() * plane.normal;
  plane.axis_u = T_map_model.linear() * plane.axis_u;
  plane.axis_v = T_map_model.linear() * plane.axis_v;
  plane.origin = T_map_model * plane.origin;
  plane.centroid = T_map_model * plane.centroid;
  plane.d_m = -plane.normal.dot(plane.origin);
}

/// Returns the surfaces without spurious planes.
std::vector<Surface> without_spurious_planes(std::vector<Surface> surfaces,
                                             const AssociationGates& gates, double bridged_gap_m,
                                             const AssemblyConfig& config) {
  std::vector<const Plane*> planes;
  for (const Surface& surface : surfaces) planes.push_back(&surface.plane());
  const std::vector<bool> spurious = are_spurious(planes, gates, bridged_gap_m, config);
  std::vector<Surface> kept;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!spurious[i]) kept.push_back(std::move(surfaces[i]));
  }
  return kept;
}

/// Returns the planes in map, ordered by id, without those that are too small, curved or spurious.
std::vector<Plane> finished(std::vector<Surface> surfaces, const AssociationGates& gates,
                            double min_area_m2, const PosedObservations& observations,
                            double bridged_gap_m, const AssemblyConfig& config) {
  std::vector<Plane> planes;
  for (Surface& surface : surfaces) {
    if (surface.plane().area_m2 < min_area_m2 || is_curved(surface.plane(), config)) continue;
    planes.push_back(surface.take_plane());
  }
  planes = without_spurious_planes(std::move(planes), gates, bridged_gap_m, config);
  for (Plane& plane : planes) move(plane, observations.T_map_model());
  std::sort(planes.begin(), planes.end(),
            [](const Plane& a, const Plane& b) { return a.id < b.id; });
  return planes;
}

/// Splits hypotheses where necessary and collects the surfaces of the parts.
class Assembly {
 public:
  Assembly(const AssociationGates& gates, const PosedObservations& observations,
           const SurfaceConfig& surface_config, const AssemblyConfig& config)
      : gates_(gates),
        observations_(observations),
        surface_config_(surface_config),
        config_(config),
        // Includes small planes, so that their points are not assigned to others.
        min_m2_(std::min(config.min_area_as_built_m2, config.min_area_m2)) {}

  /// Adds the surfaces of a hypothesis.
  void add(const Hypothesis& whole) {
    std::optional<Surface> surface = surface_of(whole);
    if (!surface) return;
    const auto pieces = split(whole, surface->plane(), surface_config_.stripe_gap_m, observations_);
    if (pieces.size() == 1) return surfaces_.push_back(std::move(*surface));
    const auto groups = group_agreeing(pieces, gates_, surface_config_.bridged_gap_m);
    if (groups.size() == 1) return add_connected(whole, std::move(*surface));
    for (const Hypothesis& group : groups) {
      if (auto grouped = surface_of(group)) add_connected(group, std::move(*grouped));
    }
  }

  /// Moves the surfaces out.
  std::vector<Surface> take() { return std::move(surfaces_); }

 private:
  /// Returns the surface of a hypothesis, or nothing if it is too small.
  std::optional<Surface> surface_of(const Hypothesis& hypothesis) const {
    const double cell_size_m = surface_config_.cell_size_m;
    if (!is_promising(min_m2_, hypothesis, observations_, cell_size_m, config_)) {
      return std::nullopt;
    }
    Surface surface(hypothesis, observations_, cell_size_m);
    if (surface.plane().area_m2 < min_m2_) return std::nullopt;
    return surface;
  }

  /// Adds the surfaces of the parts between gaps that are too wide to be bridged.
  void add_connected(const Hypothesis& group, Surface surface) {
    const auto parts = split(group, surface.plane(), surface_config_.bridged_gap_m, observations_);
    if (parts.size() == 1) return add_tops(group, std::move(surface));
    for (const Hypothesis& part : parts) {
      if (auto connected = surface_of(part)) add_tops(part, std::move(*connected));
    }
  }

  /// Adds a surface; the tops of several pieces of furniture one by one.
  void add_tops(const Hypothesis& whole, Surface surface) {
    if (!is_top(whole, observations_)) return surfaces_.push_back(std::move(surface));
    const auto tops = divide_tops(whole, surface.plane(), surface_config_.stripe_gap_m,
                                  config_.min_area_m2, observations_);
    if (tops.size() == 1) return surfaces_.push_back(std::move(surface));
    for (const Hypothesis& top : tops) {
      surfaces_.emplace_back(top, observations_, surface_config_.cell_size_m);
    }
  }

  const AssociationGates& gates_;
  const PosedObservations& observations_;
  const SurfaceConfig& surface_config_;
  const AssemblyConfig& config_;
  double min_m2_;
  std::vector<Surface> surfaces_;
};

}  // namespace

std::vector<Plane> assembled_as_built(const std::vector<Hypothesis>& hypotheses,
                                      const AssociationGates& gates,
                                      const PosedObservations& observations,
                                      const SurfaceConfig& surface_config,
                                      const AssemblyConfig& config) {
  const double cell_size_m = surface_config.cell_size_m;
  const double min_area_m2 = config.min_area_as_built_m2;
  std::vector<Surface> surfaces;
  for (const Hypothesis& hypothesis : hypotheses) {
    if (!is_promising(min_area_m2, hypothesis, observations, cell_size_m, config)) continue;
    surfaces.emplace_back(hypothesis, observations, cell_size_m);
  }
  return finished(std::move(surfaces), gates, min_area_m2, observations,
                  surface_config.bridged_gap_m, config);
}

PlaneModel assembled_planes(const std::vector<Hypothesis>& hypotheses,
                            const AssociationGates& gates, const PosedObservations& observations,
                            const SurfaceConfig& surface_config, const AssemblyConfig& config) {
  const double bridged_gap_m = surface_config.bridged_gap_m;
  Assembly assembly(gates, observations, surface_config, config);
  for (const Hypothesis& hypothesis : hypotheses) assembly.add(hypothesis);
  std::vector<Surface> surfaces =
      without_spurious_planes(assembly.take(), gates, bridged_gap_m, config);
  assign_points(observations, config, surfaces);
  surfaces.erase(std::remove_if(surfaces.begin(), surfaces.end(),
                                [&](const Surface& surface) {
                                  return is_row_of_objects(surface.plane(), gates, config);
                                }),
                 surfaces.end());
  PlaneModel model{
      finished(std::move(surfaces), gates, config.min_area_m2, observations, bridged_gap_m, config),
      {}};
  if (config.passed_lines > 0) {
    model = without_passed_cells(std::move(model.planes), observations, config);
  }
  for (Plane& plane : model.planes) plane.outlines = outlines_of(plane, surface_config);
  join_at_corner_lines(model.planes, kCornerReachInCells * surface_config.cell_size_m);
  return model;
}

}  // namespace ribbon_mapper
