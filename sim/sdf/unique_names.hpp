// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tinyxml2.h>

#include <cstddef>

namespace ribbon_mapper::sim {

/// Renames, below `parent`, each element whose name an earlier child of the same element has, as
/// Gazebo does: chair, chair_0, chair_1. Returns how many were renamed.
std::size_t make_names_unique(tinyxml2::XMLElement& parent);

}  // namespace ribbon_mapper::sim
