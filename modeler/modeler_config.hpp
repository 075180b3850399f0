// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "modeler/assembly/assembly_config.hpp"
#include "modeler/association/association_config.hpp"
#include "modeler/maps/maps_config.hpp"
#include "modeler/observations/observations_config.hpp"
#include "modeler/registration/registration_config.hpp"
#include "modeler/ribbon/ribbon_config.hpp"
#include "modeler/scan/scan_config.hpp"
#include "modeler/surface/surface_config.hpp"
#include "modeler/trajectory/trajectory_config.hpp"

namespace ribbon_mapper {

/// The configuration of a modeler, one part for each stage. config/pr2.yaml lists every key.
struct ModelerConfig {
  ScanConfig scan;                  ///< ranges to lines
  RibbonConfig ribbon;              ///< lines to ribbons
  TrajectoryConfig trajectory;      ///< effect of a correction on later lines
  ObservationsConfig observations;  ///< size of the model
  AssociationConfig association;    ///< ribbons to hypotheses
  SurfaceConfig surface;            ///< cells of a plane
  AssemblyConfig assembly;          ///< hypotheses to planes
  RegistrationConfig registration;  ///< lines between corrected poses
  MapsConfig maps;                  ///< free space and the map for navigation

  /// Throws std::invalid_argument with the key, its value and the allowed range if a value is out
  /// of range.
  void validate() const;
};

}  // namespace ribbon_mapper
