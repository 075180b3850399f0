// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "modeler/observations/posed_observations.hpp"

namespace ribbon_mapper {

/// Returns the ascending indices of the `count` ribbons to keep, or all if there are no more.
///
/// Repeatedly drops the ribbon whose least-covered stretch is covered by the most ribbons of
/// similar orientation. So sparsely observed areas are never thinned.
std::vector<std::uint32_t> thinned(const PosedObservations& observations, std::size_t count);

}  // namespace ribbon_mapper
