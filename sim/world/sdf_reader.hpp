// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sim/shapes/shape.hpp"

namespace ribbon_mapper::sim {

/// Reads all collision elements of an SDF file, posed in its world frame. URIs (`model://`,
/// `file://`, relative) are looked up in the folder of the referring file, then in `model_paths`.
/// Throws std::runtime_error that names the file and says what to do.
std::vector<Shape> read_sdf(const std::string& path, const std::vector<std::string>& model_paths);

}  // namespace ribbon_mapper::sim
