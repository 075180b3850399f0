// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/modeler_config.hpp"

namespace ribbon_mapper {

/// A key of the configuration that is not at its default.
struct ChangedKey {
  std::string name;           ///< such as "scan.max_range_m"
  std::string value;          ///< as in a preset
  std::string default_value;  ///< as in a preset
};

/// Returns the keys that are not at their defaults, in the order of visit_keys().
std::vector<ChangedKey> changed_keys(const ModelerConfig& config);

}  // namespace ribbon_mapper
