// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "modeler/modeler_config.hpp"

namespace ribbon_mapper {

/// Reads a preset (config/*.yaml): sections of keys; keys that are left out keep their defaults.
/// Throws std::invalid_argument that names the file, the key and what is allowed, if the file
/// cannot be read, a key is unknown, a value is of the wrong kind or out of range.
ModelerConfig load_config(const std::string& path);

/// A preset with every key, which load_config() reads as the same values.
std::string config_to_yaml(const ModelerConfig& config);

}  // namespace ribbon_mapper
