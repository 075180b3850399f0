// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "modeler/association/association_config.hpp"
#include "modeler/association/hypothesis.hpp"
#include "modeler/observations/observations.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Planes with their cells from the hypotheses that are confirmed as built on the way: with ribbons
/// and a seen area enough. In the map frame, without outlines.
std::vector<Plane> confirmed_planes(const std::vector<Hypothesis>& hypotheses,
                                    const Observations& observations, const PlaneMapConfig& config);

/// The final filtering, on hypotheses that were merged within `gates`: planes fall apart where a
/// gap is too wide to be bridged, or where what lies beyond it does not agree; small planes, curved
/// ones and bevels are dropped. In the map frame, with outlines.
std::vector<Plane> filtered_planes(const std::vector<Hypothesis>& hypotheses,
                                   const AssociationGates& gates, const Observations& observations,
                                   const PlaneMapConfig& config);

}  // namespace ribbon_mapper
