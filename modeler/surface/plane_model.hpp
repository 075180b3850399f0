// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// The planes of a model, and which ribbons are of things that are no longer there.
struct PlaneModel {
  std::vector<Plane> planes;  ///< in map, ordered by id
  /// Ribbons of planes that later beams have passed, see without_passed_cells(): ascending indices.
  std::vector<std::uint32_t> gone_ribbons;
};

}  // namespace ribbon_mapper
