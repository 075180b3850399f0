// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Checks that `name` is a plain file name: a letter, digit or '_', then up to 63 letters, digits,
/// '_', '.' or '-', without "..". Throws std::invalid_argument otherwise.
void check_save_name(const std::string& name);

/// Writes planes into `directory`, which is created if needed: <name>.json, the mesh <name>.ply
/// with stripes of up to `stripe_gap_m` closed, the cells <name>_cells.ply and the OctoMap
/// <name>.bt. Older files are replaced only after all four are on the disk. Returns the four paths.
/// Throws std::invalid_argument for a bad name, and std::runtime_error with the file, the reason
/// and a remedy.
std::vector<std::filesystem::path> save_model(const std::vector<Plane>& planes,
                                              const std::filesystem::path& directory,
                                              const std::string& name, double stripe_gap_m);

}  // namespace ribbon_mapper
