// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/association/hypothesis.hpp"
#include "modeler/observations/posed_observations.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Splits a hypothesis at gaps wider than `gap_m`. Returns one hypothesis for each piece, the
/// largest first, which keeps the id. `plane` holds the cells of `whole`.
std::vector<Hypothesis> split(const Hypothesis& whole, const Plane& plane, double gap_m,
                              const PosedObservations& observations);

/// Returns true if a hypothesis is level, seen from above, and everywhere more than 0.2 m above the
/// ground on which the robot stood: the top of a table, a bed or a shelf.
bool is_top(const Hypothesis& hypothesis, const PosedObservations& observations);

/// Divides the tops of several pieces of furniture at gaps wider than `gap_m`, if at least two
/// parts have `min_area_m2`. Smaller parts stay with the large one whose middle is nearest. Returns
/// one hypothesis for each top, the first of which keeps the id. `plane` holds the cells of
/// `whole`.
std::vector<Hypothesis> divide_tops(const Hypothesis& whole, const Plane& plane, double gap_m,
                                    double min_area_m2, const PosedObservations& observations);

/// Unites the pieces of a plane that agree within the gates. Returns one hypothesis for each group.
///
/// Two adjacent objects at different heights may have been taken for one slightly tilted plane. So
/// pieces stay together only if their own fits agree. Pieces of up to `max_object_m` in length may
/// be separate objects, and must also be level with the rest.
std::vector<Hypothesis> group_agreeing(const std::vector<Hypothesis>& pieces,
                                       const AssociationGates& gates, double max_object_m);

}  // namespace ribbon_mapper
