// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "modeler/ribbon/ribbon_config.hpp"
#include "modeler/scan/beam_range.hpp"
#include "modeler/scan/scan_config.hpp"
#include "modeler/scan/scan_line.hpp"

namespace ribbon_mapper {

/// Returns the beam at which a line of returns bends most, if it does. The returns are successive
/// beams of one segment.
///
/// The line is a polyline of two pieces. Its bend is steeper than RibbonConfig::min_bend_deg and
/// than four standard errors of its angle. The leaf of a door that stands ajar is found so.
std::optional<std::size_t> find_bend(const ScanLine& line, const BeamRange& beams,
                                     const ScanConfig& scan, const RibbonConfig& config);

}  // namespace ribbon_mapper
