// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "sim/sdf/sdf_file.hpp"
#include "sim/sdf/sdf_notes.hpp"

namespace ribbon_mapper::sim {

/// Names of the elements that are read in one place.
using ElementNames = std::vector<std::string>;

/// Notes an element that is left out. Throws as SdfScope::fail() if it is no element of SDF and
/// looks as if it was meant to be seen: its name is nearly one of `read_here`, or it holds a shape.
void leave_out(const tinyxml2::XMLElement& element, const ElementNames& read_here,
               const SdfScope& scope, SdfNotes& notes);

}  // namespace ribbon_mapper::sim
