// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/assembly/assembly_config.hpp"
#include "modeler/observations/posed_observations.hpp"
#include "modeler/surface/surface.hpp"

namespace ribbon_mapper {

/// Gives each point of no ribbon, or of a ribbon of no surface (one whose normal was spoilt by an
/// edge or a short base line), to the surface that it lies on, beside what ribbons have seen of
/// that: the area of a small plane, or of one seen at a slant, is that of all that was seen.
void assign_points(const PosedObservations& observations, const AssemblyConfig& config,
                   std::vector<Surface>& surfaces);

}  // namespace ribbon_mapper
