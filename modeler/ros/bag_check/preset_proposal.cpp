// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/preset_proposal.hpp"

#include <array>
#include <stdexcept>

#include "modeler/io/config_file.hpp"
#include "modeler/modeler.hpp"
#include "modeler/report/changed_keys.hpp"
#include "modeler/ros/bag_check/line_spacing.hpp"
#include "modeler/ros/bag_check/number_text.hpp"
#include "modeler/ros/bag_check/scan_survey.hpp"
#include "modeler/ros/bag_check/tilt_survey.hpp"

namespace ribbon_mapper {
namespace {

/// Lines with their poses.
using Lines = std::vector<ReadyLine>;

constexpr std::size_t kMaxLines = 5000;  // 10 MB; a longer recording tells no more
/// Growth of the planes that shows that gates were too tight.
constexpr double kGrowth = 1.1;
/// The tolerances of section 5.1 of the paper: of a standing and of a moving robot.
constexpr std::array<AssociationGates, 2> kWiderGates{{{3.2, 0.10}, {3.2, 0.25}}};

/// Returns the area of all planes, with the recorded poses as final ones.
double area_m2(const Lines& lines, const ModelerConfig& config) {
  Modeler modeler(config);
  for (const ReadyLine& line : lines) modeler.add_scan_line(line.beams, line.poses);
  const std::vector<StampedPose> trajectory = modeler.trajectory();
  if (trajectory.empty()) return 0.0;
  modeler.correct(trajectory);
  double sum_m2 = 0.0;
  for (const Plane& plane : modeler.planes()) sum_m2 += plane.area_m2;
  return sum_m2;
}

/// Widens the gates while that lets planes grow. Lasers whose mounting is not calibrated bend
/// planes by more than their noise.
void widen_gates(const Lines& lines, ModelerConfig& config) {
  double best_m2 = area_m2(lines, config);
  for (const AssociationGates& gates : kWiderGates) {
    ModelerConfig wider = config;
    if (gates.distance_m <= config.association.corrected.distance_m) continue;
    wider.association.corrected = gates;
    const double wider_m2 = area_m2(lines, wider);
    if (wider_m2 <= kGrowth * best_m2) return;
    best_m2 = wider_m2;
    config = wider;
  }
}

/// Returns a comment with the keys that are not at their defaults.
std::string changes_of(const ModelerConfig& config) {
  const std::vector<ChangedKey> changes = changed_keys(config);
  if (changes.empty()) return "# All keys are at their defaults.\n";
  std::string text = "# Keys that are not at their defaults, the others may be left out:\n";
  for (const ChangedKey& key : changes) {
    text += "#   " + key.name + ": " + key.value + " (default " + key.default_value + ")\n";
  }
  return text;
}

std::string described(const LineSpacing& spacing) {
  return "# Proposed by bag_check: lines " + degrees(spacing.line_step_rad, 2) +
         " degrees apart, beams " + degrees(spacing.beam_step_rad, 2) + " degrees; " +
         number(spacing.sweeps, 0) + " sweeps.\n# The noise of a range is about " +
         number(1e3 * spacing.noise_m, 0) + " mm; half of the ranges are below " +
         number(spacing.median_range_m, 1) + " m, nine of ten below " +
         number(spacing.far_range_m, 1) + " m.\n";
}

}  // namespace

std::string proposed_preset(const std::vector<std::filesystem::path>& bags,
                            const BagOptions& options, const ModelerConfig& preset) {
  ScanSurvey scans(preset.scan);
  TiltSurvey tilt;
  Lines lines;
  LineLog log;
  BagLines source(bags, options, log);
  while (std::optional<ReadyLine> line = source.next()) {
    if (lines.size() == kMaxLines) break;
    scans.add(line->beams);
    tilt.add(line->beams, line->poses);
    lines.push_back(std::move(*line));
  }
  if (lines.size() < 3) {
    throw std::runtime_error("no preset can be proposed: hardly any line has its poses");
  }
  const LineSpacing spacing = tilt.spacing(scans);
  ModelerConfig config = adapted(preset, spacing);
  if (spacing.base_stands) widen_gates(lines, config);
  return described(spacing) + changes_of(config) + config_to_yaml(config);
}

}  // namespace ribbon_mapper
