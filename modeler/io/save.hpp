// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Throws std::invalid_argument unless `name` is a plain file name: a letter, a digit or '_',
/// then up to 63 of these or '.' or '-', without "..".
void check_save_name(const std::string& name);

/// Writes into `directory` (created where needed): the planes as <name>.json and as the mesh
/// <name>.ply (with stripes of up to `stripe_gap_m` closed), their cells as <name>_cells.ply and as
/// the OctoMap <name>.bt. Files of an earlier save are replaced only after all four are on the
/// disk; returns their paths. Throws std::invalid_argument (the name) or std::runtime_error (which
/// file, why, what to do).
std::vector<std::filesystem::path> save_model(const std::vector<Plane>& planes,
                                              const std::filesystem::path& directory,
                                              const std::string& name, double stripe_gap_m);

}  // namespace ribbon_mapper
