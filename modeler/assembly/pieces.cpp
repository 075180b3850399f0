// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modeler/surface/cell_grid.hpp"

namespace ribbon_mapper {
namespace {

/// Ids of the pieces that a plane falls into beyond its largest: far above any hypothesis' id.
constexpr std::int64_t piece_step = 1'000'000;

/// That of the cell in the middle of the ribbon's samples.
int component_of(const PosedRibbon& ribbon, const Plane& plane,
                 const std::vector<int>& components) {
  const Eigen::Vector3d place =
      ribbon.point(ribbon.ribbon->samples.middle_m(), 0.0F) - plane.origin;
  const int u = static_cast<int>(std::floor(place.dot(plane.axis_u) / plane.cell_size_m));
  const int v = static_cast<int>(std::floor(place.dot(plane.axis_v) / plane.cell_size_m));
  const auto found = std::lower_bound(
      plane.cells.begin(), plane.cells.end(), std::pair(v, u),
      [](const PlaneCell& cell, const auto& key) { return std::pair(cell.v, cell.u) < key; });
  if (found == plane.cells.end() || found->u != u || found->v != v) return 0;
  return components[static_cast<std::size_t>(found - plane.cells.begin())];
}

/// Noise cannot have mixed two planes that lie closer together than the gate if there is a gap
/// between them: what is left is an error of the poses (a third of the gate), or of the larger
/// one's slope, which grows with the way.
bool are_level(const Hypothesis& larger, const Hypothesis& smaller, const AssociationGates& gates) {
  const Eigen::Vector3d way = smaller.fit().mean - larger.fit().mean;
  const double error_m = std::sqrt(larger.tilt_variance(way));
  return std::abs(larger.signed_distance(smaller.fit().mean)) <
         std::max(gates.distance_m / 3.0, 2.0 * error_m);
}

/// Length of a strip with the same variance.
double length_m(const Hypothesis& piece) { return std::sqrt(12.0 * piece.fit().variances[2]); }

}  // namespace

std::vector<Hypothesis> split(const Hypothesis& whole, const Plane& plane, double gap_m,
                              const PosedObservations& observations) {
  const std::vector<int> numbers = connected_components(plane.cells, plane.cell_size_m, gap_m);
  const int count = *std::max_element(numbers.begin(), numbers.end()) + 1;
  if (count == 1) return {whole};
  std::vector<Hypothesis> pieces;
  for (int i = 0; i < count; ++i) pieces.emplace_back(whole.id + i * piece_step);
  for (const Member& member : whole.members()) {
    const PosedRibbon ribbon = observations.ribbon(member.ribbon);
    pieces[component_of(ribbon, plane, numbers)].add(ribbon, member);
  }
  return pieces;
}

std::vector<Hypothesis> agreeing(const std::vector<Hypothesis>& pieces,
                                 const AssociationGates& gates, double thing_m) {
  std::vector<Hypothesis> groups;
  for (const Hypothesis& piece : pieces) {
    if (piece.members().empty()) continue;
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const Hypothesis& group_) {
      return are_one_plane(group_, piece, gates) &&
             (length_m(piece) > thing_m || are_level(group_, piece, gates));
    });
    group == groups.end() ? groups.push_back(piece) : group->absorb(piece);
  }
  return groups;
}

}  // namespace ribbon_mapper
