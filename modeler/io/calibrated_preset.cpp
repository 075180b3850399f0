// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/calibrated_preset.hpp"

#include <array>
#include <cstdio>

#include "modeler/io/config_file.hpp"

namespace ribbon_mapper {
namespace {

std::string variances(const char* name, const RibbonDeviation& deviation) {
  std::array<char, 160> text;
  std::snprintf(
      text.data(), text.size(),
      "# %s: distance %.3g m2, normals %.3g rad2, their scalar products %.3g; %zu ribbons\n", name,
      deviation.distance_variance_m2, deviation.angle_variance_rad2,
      deviation.scalar_product_variance, deviation.ribbons);
  return text.data();
}

/// Replaces line ends, which would end a YAML comment.
std::string in_one_line(std::string text) {
  for (char& character : text) {
    if (character == '\n' || character == '\r') character = ' ';
  }
  return text;
}

/// Rounds to three significant digits.
double rounded(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return std::stod(text.data());
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
