// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/ribbon/ribbon.hpp"
#include "modeler/ribbon/unassigned_points.hpp"

namespace ribbon_mapper {

/// What a model learns from one scan line. The samples and points that it refers to belong to
/// whoever made it.
struct LineObservations {
  std::vector<Ribbon> ribbons;  ///< in the order of the line's beams
  UnassignedPoints unassigned;  ///< the returns that belong to no ribbon
};

}  // namespace ribbon_mapper
