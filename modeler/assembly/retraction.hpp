// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/assembly/assembly_config.hpp"
#include "modeler/observations/posed_observations.hpp"
#include "modeler/surface/plane_model.hpp"

namespace ribbon_mapper {

/// Removes the cells of planes that later beams have passed: a cupboard was moved, a door opened.
///
/// A cell is passed if AssemblyConfig::passed_lines lines have passed it since the last line that
/// ended in it. Cells along an edge are hit and passed by turns, so only passed areas of at least
/// three by three cells count. A plane is removed whole if RetractionConfig::whole_share of its
/// cells are, or if less than `min_area_m2` remains; its ribbons are gone. `planes` are in map, of
/// these observations, at corrected poses; planes that lose cells also lose their outlines.
PlaneModel without_passed_cells(std::vector<Plane> planes, const PosedObservations& observations,
                                const AssemblyConfig& config);

}  // namespace ribbon_mapper
