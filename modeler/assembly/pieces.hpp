// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/association/hypothesis.hpp"
#include "modeler/observations/posed_observations.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// One hypothesis for each piece of the plane that is connected over gaps of at most `gap_m`, the
/// largest first; it keeps the id. `plane` holds the cells of `whole`.
std::vector<Hypothesis> split(const Hypothesis& whole, const Plane& plane, double gap_m,
                              const PosedObservations& observations);

/// Two things side by side may have passed for one plane that is tilted a little: pieces with a gap
/// between them stay together only if each by itself says so. Of pieces up to `thing_m` long, which
/// may be things of their own, it is asked that they are level with the rest.
std::vector<Hypothesis> agreeing(const std::vector<Hypothesis>& pieces,
                                 const AssociationGates& gates, double thing_m);

}  // namespace ribbon_mapper
