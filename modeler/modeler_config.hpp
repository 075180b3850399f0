// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/association/association_config.hpp"
#include "modeler/registration/registration_config.hpp"
#include "modeler/ribbon/ribbon_config.hpp"
#include "modeler/scan/scan_config.hpp"
#include "modeler/trajectory/trajectory_config.hpp"

namespace ribbon_mapper {

/// All that the modeler can be told, one struct per stage. See config/*.yaml.
struct ModelerConfig {
  ScanConfig scan;
  RibbonConfig ribbon;
  PlaneMapConfig map;
  CorrectionConfig correction;
  RegistrationConfig registration;  ///< of lines between corrected poses

  /// Throws std::invalid_argument that names the key, its value and the allowed range.
  void validate() const;
};

}  // namespace ribbon_mapper
