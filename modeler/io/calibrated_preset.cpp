// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/calibrated_preset.hpp"

#include "modeler/io/config_file.hpp"
#include "modeler/io/model_label.hpp"
#include "modeler/text/number_text.hpp"

namespace ribbon_mapper {
namespace {

/// Returns a number with three significant digits.
std::string text_of(double value) { return general_text(value, 3); }

double rounded(double value) { return number_from(text_of(value)).value_or(value); }

std::string variances(const std::string& name, const RibbonDeviation& deviation) {
  return "# " + name + ": distance " + text_of(deviation.distance_variance_m2) + " m2, normals " +
         text_of(deviation.angle_variance_rad2) + " rad2, their scalar products " +
         text_of(deviation.scalar_product_variance) + "; " + std::to_string(deviation.ribbons) +
         " ribbons\n";
}

}  // namespace

std::string calibrated_preset(const ModelerConfig& config, const Calibration& calibration,
                              const std::string& source) {
  ModelerConfig learned = with_tolerances(config, calibration);
  for (AssociationGates* gates : {&learned.association.slam, &learned.association.corrected}) {
    gates->angle_deg = rounded(gates->angle_deg);
    gates->distance_m = rounded(gates->distance_m);
  }
  return "# Tolerances learned by " + in_one_line(source) + "\n" +
         variances("V_sensor", calibration.stopped) + variances("V_slam", calibration.moving) +
         config_to_yaml(learned);
}

}  // namespace ribbon_mapper
