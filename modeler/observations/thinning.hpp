// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "modeler/observations/posed_observations.hpp"

namespace ribbon_mapper {

/// Indices, in order, of the `count` ribbons to keep so that the thinnest places stay as they are:
/// one after the other, the ribbon is left out whose every stretch is seen by the most others that
/// look the same way. All if there are no more than that.
std::vector<std::uint32_t> thinned(const PosedObservations& observations, std::size_t count);

}  // namespace ribbon_mapper
