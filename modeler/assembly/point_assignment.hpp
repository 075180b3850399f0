// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/assembly/assembly_config.hpp"
#include "modeler/observations/posed_observations.hpp"
#include "modeler/surface/surface.hpp"

namespace ribbon_mapper {

/// Assigns points to the surfaces that they lie on, near what ribbons have seen of these.
///
/// The points are the unassigned ones, and those of ribbons that belong to no surface, for example
/// because an edge or a short base line spoiled their normal. Without them, the area of a plane
/// that is small or seen at a grazing angle would be underestimated.
void assign_points(const PosedObservations& observations, const AssemblyConfig& config,
                   std::vector<Surface>& surfaces);

}  // namespace ribbon_mapper
