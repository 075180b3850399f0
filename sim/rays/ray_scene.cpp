// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/rays/ray_scene.hpp"

#include <algorithm>

namespace ribbon_mapper::sim {
namespace {

using Box = Eigen::AlignedBox3d;
using Corners = std::array<Eigen::Vector3d, 3>;

/// Oblique triangles fill little of their boxes: the boxes are those of pieces with edges up to
/// this long, or up to this share of a vast triangle's longest edge. A ray is intersected with the
/// whole facet all the same.
constexpr double kPieceEdge_m = 1.5;
constexpr double kPieceShare = 1.0 / 64.0;

/// A box as thin as this is filled by its facet.
constexpr double kFlat_m = 1e-6;

/// Boxes of flat facets have no thickness of their own, and those of pieces must not leave a gap.
constexpr double kMargin_m = 1e-4;

Box box_of(const Corners& corners) { return Box(corners[0]).extend(corners[1]).extend(corners[2]); }

double edge_m(const Corners& corners, int i) { return (corners[(i + 1) % 3] - corners[i]).norm(); }

int longest_edge(const Corners& corners) {
  int longest = 0;
  for (const int i : {1, 2})
    if (edge_m(corners, i) > edge_m(corners, longest)) longest = i;
  return longest;
}

/// Halves the longest edge until it is short enough.
void add_pieces(const Corners& corners, double short_enough_m, std::vector<Box>& boxes) {
  const int longest = longest_edge(corners);
  if (edge_m(corners, longest) <= short_enough_m) return boxes.push_back(box_of(corners));
  const Eigen::Vector3d &from = corners[longest], &to = corners[(longest + 1) % 3];
  const Eigen::Vector3d &opposite = corners[(longest + 2) % 3], middle = (from + to) / 2.0;
  add_pieces({from, middle, opposite}, short_enough_m, boxes);
  add_pieces({middle, to, opposite}, short_enough_m, boxes);
}

/// Boxes that cover a facet.
std::vector<Box> boxes_of(const FacetOfTriangles& facet, const std::vector<Triangle>& triangles) {
  Box whole;
  for (std::size_t i = 0; i < facet.count; ++i)
    whole.extend(box_of(triangles[facet.first + i].corners_m));
  if (whole.sizes().minCoeff() < kFlat_m) return {whole};
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < facet.count; ++i) {
    const Corners& corners = triangles[facet.first + i].corners_m;
    const double longest_m = edge_m(corners, longest_edge(corners));
    add_pieces(corners, std::max(kPieceEdge_m, kPieceShare * longest_m), boxes);
  }
  return boxes;
}

}  // namespace

RayScene::RayScene(const std::vector<Triangle>& triangles) {
  const std::vector<FacetOfTriangles> facets = facets_of(triangles);
  std::vector<Box> boxes;
  std::vector<int> ids;
  for (const FacetOfTriangles& facet : facets) {
    for (const Box& box : boxes_of(facet, triangles)) {
      boxes.push_back(box);
      ids.push_back(static_cast<int>(faces.size()));
    }
    faces.push_back(triangles[facet.first].face);
  }
  tree = BoxTree(boxes, kMargin_m);
  for (const std::int32_t box : tree.items) items.push_back({facets[ids[box]].facet, ids[box]});
}

}  // namespace ribbon_mapper::sim
