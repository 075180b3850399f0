// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/assembly/assembly_config.hpp"
#include "modeler/association/association_config.hpp"
#include "modeler/association/hypothesis.hpp"
#include "modeler/observations/posed_observations.hpp"
#include "modeler/surface/plane_model.hpp"
#include "modeler/surface/surface_config.hpp"

namespace ribbon_mapper {

/// Returns the planes of the hypotheses as they were aggregated on the way, within `gates`: those
/// with enough ribbons and seen area. They are in map, ordered by id, with cells and without
/// outlines.
std::vector<Plane> assembled_as_built(const std::vector<Hypothesis>& hypotheses,
                                      const AssociationGates& gates,
                                      const PosedObservations& observations,
                                      const SurfaceConfig& surface_config,
                                      const AssemblyConfig& config);

/// Returns the planes of a model from hypotheses that were merged within `gates`.
///
/// A hypothesis is split where a gap is too wide to be bridged, or where the part beyond a gap does
/// not agree. Small, curved and spurious planes are removed. The planes have cells and outlines.
PlaneModel assembled_planes(const std::vector<Hypothesis>& hypotheses,
                            const AssociationGates& gates, const PosedObservations& observations,
                            const SurfaceConfig& surface_config, const AssemblyConfig& config);

}  // namespace ribbon_mapper
