// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/map/plane_builder.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "modeler/map/bevel.hpp"
#include "modeler/map/cell_grid.hpp"
#include "modeler/map/curvature.hpp"
#include "modeler/map/outline.hpp"

namespace ribbon_mapper {
namespace {

/// Ids of the pieces that a plane falls into beyond its largest: far above any hypothesis' id.
constexpr std::int64_t piece_step = 1'000'000;

void set_frame(const Hypothesis& hypothesis, Plane& plane) {
  plane.normal = hypothesis.normal();
  plane.d_m = hypothesis.d_m();
  plane.origin = -plane.d_m * plane.normal;
  const bool is_level = std::abs(plane.normal.z()) > 0.9;
  const Eigen::Vector3d other = is_level ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  plane.axis_u = other.cross(plane.normal).normalized();  // horizontal on walls
  plane.axis_v = plane.normal.cross(plane.axis_u);
}

/// The errors of a ribbon's points are one error, that of its pose: a ribbon counts as one
/// measurement of its mean. Parameters: see Plane::covariance.
Eigen::Matrix3d covariance_of(const Hypothesis& hypothesis, const Plane& plane) {
  const Eigen::Matrix3d spread = hypothesis.moments().covariance();
  Eigen::Matrix<double, 3, 2> axes;
  axes << plane.axis_u, plane.axis_v;
  const Eigen::Matrix2d extent = axes.transpose() * spread * axes;
  const double variance =
      hypothesis.fit().variances[0] / static_cast<double>(hypothesis.members().size());
  const Eigen::Matrix2d slopes = variance * extent.inverse();  // of d(height)/du, d(height)/dv
  Eigen::Matrix2d to_rotations;
  to_rotations << 0.0, 1.0, -1.0, 0.0;  // a slope along v is a rotation about u
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance.topLeftCorner<2, 2>() = to_rotations * slopes * to_rotations.transpose();
  covariance(2, 2) = variance;
  return covariance;
}

Plane build_plane(const Hypothesis& hypothesis, const Evidence& evidence,
                  const PlaneMapConfig& config) {
  Plane plane;
  plane.id = hypothesis.id;
  plane.cell_size_m = config.cell_size_m;
  plane.ribbon_count = hypothesis.members().size();
  set_frame(hypothesis, plane);
  plane.covariance = covariance_of(hypothesis, plane);
  CellGrid grid(plane);
  for (const Member& member : hypothesis.members()) grid.add(evidence.ribbon(member.ribbon));
  plane.cells = grid.cells();
  plane.area_m2 = plane.cells.size() * config.cell_size_m * config.cell_size_m;
  for (const PlaneCell& cell : plane.cells) plane.centroid += cell_centre(plane, cell);
  plane.centroid /= static_cast<double>(plane.cells.size());
  return plane;
}

/// False if a hypothesis has too few ribbons to be confirmed, or if even the cells of all their
/// samples cannot have this area.
bool is_promising(double area_m2, const Hypothesis& hypothesis, const Evidence& evidence,
                  const PlaneMapConfig& config) {
  if (hypothesis.members().size() < static_cast<std::size_t>(config.confirmed_ribbons)) {
    return false;
  }
  double most_m2 = 0.0;
  for (const Member& member : hypothesis.members()) {
    most_m2 += evidence.ribbon(member.ribbon).ribbon->samples.size() * config.cell_size_m *
               config.cell_size_m;
    if (most_m2 >= area_m2) return true;
  }
  return false;
}

int component_of(const PosedRibbon& ribbon, const Plane& plane,
                 const std::map<std::pair<int, int>, int>& components) {
  const auto& samples = ribbon.ribbon->samples;
  const Eigen::Vector3d place =
      ribbon.T_world_base * samples[samples.size() / 2].point.cast<double>() - plane.origin;
  const int u = static_cast<int>(std::floor(place.dot(plane.axis_u) / plane.cell_size_m));
  const int v = static_cast<int>(std::floor(place.dot(plane.axis_v) / plane.cell_size_m));
  const auto found = components.find({u, v});
  return found == components.end() ? 0 : found->second;
}

/// One hypothesis for each piece of the plane that is connected over gaps of at most `gap_m`; the
/// largest keeps the id.
std::vector<Hypothesis> split(const Hypothesis& whole, const Plane& plane, double gap_m,
                              const Evidence& evidence) {
  const std::vector<int> numbers = connected_components(plane.cells, plane.cell_size_m, gap_m);
  const int count = *std::max_element(numbers.begin(), numbers.end()) + 1;
  if (count == 1) return {whole};
  std::map<std::pair<int, int>, int> components;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    components[{plane.cells[i].u, plane.cells[i].v}] = numbers[i];
  }
  std::vector<Hypothesis> pieces;
  for (int i = 0; i < count; ++i) pieces.emplace_back(whole.id + i * piece_step);
  for (const Member& member : whole.members()) {
    const PosedRibbon ribbon = evidence.ribbon(member.ribbon);
    pieces[component_of(ribbon, plane, components)].add(ribbon, member);
  }
  return pieces;
}

/// Two things side by side may have passed for one plane that is tilted a little: pieces with a gap
/// between them stay together only if each by itself says so.
std::vector<Hypothesis> agreeing(const std::vector<Hypothesis>& pieces,
                                 const AssociationGates& gates) {
  std::vector<Hypothesis> groups;
  for (const Hypothesis& piece : pieces) {
    if (piece.members().empty()) continue;
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const Hypothesis& group_) {
      return are_one_plane(group_, piece, gates);
    });
    group == groups.end() ? groups.push_back(piece) : group->absorb(piece);
  }
  return groups;
}

/// A facet of a column is no plane.
bool is_curved(const Plane& plane, const PlaneMapConfig& config) {
  const Curvature curvature = curvature_of(plane);
  return curvature.bend - config.curvature_sigmas * curvature.sigma > 1.0 / config.least_radius_m;
}

void move(Plane& plane, const Pose& T_map_world) {
  plane.normal = T_map_world.linear() * plane.normal;
  plane.axis_u = T_map_world.linear() * plane.axis_u;
  plane.axis_v = T_map_world.linear() * plane.axis_v;
  plane.origin = T_map_world * plane.origin;
  plane.centroid = T_map_world * plane.centroid;
  plane.d_m = -plane.normal.dot(plane.origin);
}

}  // namespace

std::vector<Plane> confirmed_planes(const std::vector<Hypothesis>& hypotheses,
                                    const Evidence& evidence, const PlaneMapConfig& config) {
  std::vector<Plane> planes;
  for (const Hypothesis& hypothesis : hypotheses) {
    if (!is_promising(config.confirmed_area_m2, hypothesis, evidence, config)) continue;
    Plane plane = build_plane(hypothesis, evidence, config);
    if (plane.area_m2 < config.confirmed_area_m2 || is_curved(plane, config)) continue;
    planes.push_back(std::move(plane));
  }
  planes = without_bevels(std::move(planes), config);
  for (Plane& plane : planes) move(plane, evidence.T_map_world());
  std::sort(planes.begin(), planes.end(),
            [](const Plane& a, const Plane& b) { return a.id < b.id; });
  return planes;
}

std::vector<Plane> filtered_planes(const std::vector<Hypothesis>& hypotheses,
                                   const AssociationGates& gates, const Evidence& evidence,
                                   const PlaneMapConfig& config) {
  std::vector<Plane> planes;
  const auto is_plane = [&](const Plane& plane) {
    return plane.area_m2 >= config.least_area_m2 && !is_curved(plane, config);
  };
  for (const Hypothesis& whole : hypotheses) {
    if (!is_promising(config.least_area_m2, whole, evidence, config)) continue;
    const Plane rough = build_plane(whole, evidence, config);
    if (rough.area_m2 < config.least_area_m2) continue;
    const auto pieces = split(whole, rough, config.stripe_gap_m, evidence);
    for (const Hypothesis& group : agreeing(pieces, gates)) {
      if (!is_promising(config.least_area_m2, group, evidence, config)) continue;
      const Plane plane = build_plane(group, evidence, config);
      for (const Hypothesis& part : split(group, plane, config.bridged_gap_m, evidence)) {
        if (!is_promising(config.least_area_m2, part, evidence, config)) continue;
        Plane candidate = build_plane(part, evidence, config);
        if (is_plane(candidate)) planes.push_back(std::move(candidate));
      }
    }
  }
  planes = without_bevels(std::move(planes), config);
  for (Plane& plane : planes) {
    move(plane, evidence.T_map_world());
    plane.outline = outline_of(plane, config.bridged_gap_m);
  }
  std::sort(planes.begin(), planes.end(),
            [](const Plane& a, const Plane& b) { return a.id < b.id; });
  return planes;
}

}  // namespace ribbon_mapper
