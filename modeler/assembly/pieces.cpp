// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/assembly/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modeler/surface/cell_grid.hpp"
#include "modeler/surface/surface.hpp"

namespace ribbon_mapper {
namespace {

/// Difference between the ids of successive pieces of a plane: far above any hypothesis' id.
constexpr std::int64_t kPieceIdStep = 1'000'000;

/// The same for the tops of furniture, above that of pieces.
constexpr std::int64_t kTopIdStep = 1'000'000'000;
constexpr double kTopHeight_m = 0.2;          // above the ground: no robot drives there
constexpr double kTopCosine = 0.98480775301;  // cosine of 10 degrees

/// Returns the component of the cell in the middle of the ribbon's samples.
int component_of(const PosedRibbon& ribbon, const Plane& plane,
                 const std::vector<int>& components) {
  const Eigen::Vector3d offset =
      ribbon.point(ribbon.ribbon->samples.middle_m(), 0.0F) - plane.origin;
  const int u = static_cast<int>(std::floor(offset.dot(plane.axis_u) / plane.cell_size_m));
  const int v = static_cast<int>(std::floor(offset.dot(plane.axis_v) / plane.cell_size_m));
  const auto found = std::lower_bound(
      plane.cells.begin(), plane.cells.end(), std::pair(v, u),
      [](const PlaneCell& cell, const auto& key) { return std::pair(cell.v, cell.u) < key; });
  if (found == plane.cells.end() || found->u != u || found->v != v) return 0;
  return components[static_cast<std::size_t>(found - plane.cells.begin())];
}

/// Returns true if the smaller piece is at the level of the larger one's plane.
///
/// The tolerance is narrower than the gate: across a gap, noise cannot have mixed two planes. There
/// remain errors of the poses (a third of the gate) and the error of the larger one's slope, which
/// grows with the distance.
bool are_level(const Hypothesis& larger, const Hypothesis& smaller, const AssociationGates& gates) {
  const Eigen::Vector3d offset = smaller.fit().mean - larger.fit().mean;
  const double error_m = std::sqrt(larger.tilt_variance(offset));
  return std::abs(larger.signed_distance(smaller.fit().mean)) <
         std::max(gates.distance_m / 3.0, 2.0 * error_m);
}

/// Returns the length of a strip with the variance of the piece along its larger extent.
double length_m(const Hypothesis& piece) { return std::sqrt(12.0 * piece.fit().variances[2]); }

/// Returns the hypothesis whose middle is nearest to that of a piece.
Hypothesis& nearest_to(const Hypothesis& piece, std::vector<Hypothesis>& hypotheses) {
  const auto distance = [&](const Hypothesis& other) {
    return (other.fit().mean - piece.fit().mean).squaredNorm();
  };
  return *std::min_element(
      hypotheses.begin(), hypotheses.end(),
      [&](const Hypothesis& a, const Hypothesis& b) { return distance(a) < distance(b); });
}

}  // namespace

bool is_top(const Hypothesis& hypothesis, const PosedObservations& observations) {
  const Eigen::Vector3d normal = observations.T_map_model().linear() * hypothesis.normal();
  if (normal.z() < kTopCosine) return false;
  const auto is_high = [&](const Member& member) {
    return observations.source(member.ribbon).moments.mean().z() > kTopHeight_m;
  };
  return std::all_of(hypothesis.members().begin(), hypothesis.members().end(), is_high);
}

std::vector<Hypothesis> divide_tops(const Hypothesis& whole, const Plane& plane, double gap_m,
                                    double min_area_m2, const PosedObservations& observations) {
  std::vector<Hypothesis> tops, small;
  for (Hypothesis& piece : split(whole, plane, gap_m, observations)) {
    if (piece.members().empty()) continue;
    const Surface surface(piece, observations, plane.cell_size_m);
    (surface.plane().area_m2 >= min_area_m2 ? tops : small).push_back(std::move(piece));
  }
  if (tops.size() < 2) return {whole};
  for (std::size_t i = 0; i < tops.size(); ++i) {
    tops[i].id = whole.id + static_cast<std::int64_t>(i) * kTopIdStep;
  }
  std::vector<Hypothesis> united = tops;
  for (const Hypothesis& piece : small) {
    const auto into = &nearest_to(piece, tops) - tops.data();
    united[static_cast<std::size_t>(into)].absorb(piece);
  }
  return united;
}

std::vector<Hypothesis> split(const Hypothesis& whole, const Plane& plane, double gap_m,
                              const PosedObservations& observations) {
  const std::vector<int> numbers = connected_components(plane.cells, plane.cell_size_m, gap_m);
  const int count = *std::max_element(numbers.begin(), numbers.end()) + 1;
  if (count == 1) return {whole};
  std::vector<Hypothesis> pieces;
  for (int i = 0; i < count; ++i) pieces.emplace_back(whole.id + i * kPieceIdStep);
  for (const Member& member : whole.members()) {
    const PosedRibbon ribbon = observations.ribbon(member.ribbon);
    pieces[component_of(ribbon, plane, numbers)].add(ribbon, member);
  }
  return pieces;
}

std::vector<Hypothesis> group_agreeing(const std::vector<Hypothesis>& pieces,
                                       const AssociationGates& gates, double max_object_m) {
  std::vector<Hypothesis> groups;
  for (const Hypothesis& piece : pieces) {
    if (piece.members().empty()) continue;
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const Hypothesis& group_) {
      return are_one_plane(group_, piece, gates) &&
             (length_m(piece) > max_object_m || are_level(group_, piece, gates));
    });
    group == groups.end() ? groups.push_back(piece) : group->absorb(piece);
  }
  return groups;
}

}  // namespace ribbon_mapper
