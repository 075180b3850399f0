// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/preset_proposal.hpp"

#include <array>
#include <stdexcept>

#include "modeler/assembly/model_quality.hpp"
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

/// What tells whether gates suit a recording.
struct GateTrial {
  double area_m2 = 0.0;        ///< of all planes
  std::size_t duplicates = 0;  ///< planes that others have already: gates were too tight
  double residual_m = 0.0;     ///< beyond the noise of a range, gates were too wide

  bool explains_more_than(const GateTrial& other) const {
    return duplicates < other.duplicates ||
           (duplicates == other.duplicates && area_m2 > kGrowth * other.area_m2);
  }
};

/// Returns how the model turns out, with the recorded poses as final ones.
GateTrial trial_of(const Lines& lines, const ModelerConfig& config) {
  Modeler modeler(config);
  for (const ReadyLine& line : lines) modeler.add_scan_line(line.beams, line.poses);
  const std::vector<StampedPose> trajectory = modeler.trajectory();
  if (trajectory.empty()) return {};
  modeler.correct(trajectory);
  const std::vector<Plane> planes = modeler.planes();
  DuplicateRule rule;
  rule.touching_m = config.surface.stripe_gap_m;
  GateTrial trial{0.0, duplicates_of_larger(planes, rule).size(),
                  median_residual_m(planes).value_or(0.0)};
  for (const Plane& plane : planes) trial.area_m2 += plane.area_m2;
  return trial;
}

/// Widens the gates where that lets planes grow or leaves fewer duplicates, and planes stay as
/// thin as the noise. Lasers whose mounting is not calibrated bend planes by more than their noise.
void widen_gates(const Lines& lines, ModelerConfig& config) {
  GateTrial best = trial_of(lines, config);
  for (const AssociationGates& gates : kWiderGates) {
    if (gates.distance_m <= config.association.corrected.distance_m) continue;
    ModelerConfig wider = config;
    wider.association.corrected = gates;
    const GateTrial trial = trial_of(lines, wider);
    if (trial.residual_m > config.scan.range_sigma_m) return;
    if (!trial.explains_more_than(best)) continue;
    best = trial;
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
