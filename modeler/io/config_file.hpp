// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "modeler/modeler_config.hpp"

namespace ribbon_mapper {

/// Reads a preset (config/*.yaml). Keys that are not in the file keep their defaults. Throws
/// std::invalid_argument with the file, the key and the allowed values if the file cannot be read,
/// a key is unknown, or a value has the wrong type or is out of range.
ModelerConfig load_config(const std::string& path);

/// Returns a preset with all keys, from which load_config() reads the same values.
std::string config_to_yaml(const ModelerConfig& config);

}  // namespace ribbon_mapper
