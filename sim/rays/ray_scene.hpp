// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "sim/rays/box_tree.hpp"
#include "sim/shapes/facet.hpp"

namespace ribbon_mapper::sim {

/// What rays are cast into: facets in the leaves of a tree.
struct RayScene {
  struct Item {
    Facet facet;
    int id;  ///< of the facet, in the order of the triangles
  };
  std::vector<int> faces;   ///< index into Tessellation::faces of each facet, by id
  std::vector<Item> items;  ///< leaf by leaf; a facet of several pieces several times
  BoxTree tree{{}, 0.0};

  explicit RayScene(const std::vector<Triangle>& triangles);
};

}  // namespace ribbon_mapper::sim
