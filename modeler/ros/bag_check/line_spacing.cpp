// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/line_spacing.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/geometry/angles.hpp"
#include "modeler/ros/bag_check/number_text.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kBeamStepOfPr2_rad = 0.25 * kDegree;
constexpr double kMaxCell_m = 0.25;
/// Lines and beams are this much further apart on a surface that is seen at 60 degrees from its
/// normal.
constexpr double kObliqueGaps = 2.0;
constexpr int kMinRibbons = 5;              // fewer make no plane that can be trusted
constexpr double kAveragingBaseLine = 3.0;  // see ScanConfig::base_line_sigmas
/// Steps between ranges that noise reaches hardly ever.
constexpr double kNoiseSteps = 3.0;
constexpr double kMuchNoise = 1.5;  // times scan.range_sigma_m

/// Rounds up to a part of a unit: a division gives the double nearest to a decimal, 0.3 and not
/// 0.30000000000000004.
double rounded_up(double value, double parts) { return std::ceil(value * parts - 1e-9) / parts; }

/// Rounds to a hundredth of a unit, so that presets are easy to read.
double to_hundredths(double value) { return std::round(100.0 * value) / 100.0; }

bool lines_are_within_noise(const LineSpacing& spacing) {
  return spacing.line_step_rad * spacing.median_range_m < spacing.noise_m;
}

/// Returns the largest scan.mixed_pixel_angle_deg at which noise does not look like mixed pixels.
double max_mixed_pixel_angle_deg(const LineSpacing& spacing) {
  const double step_m = std::sin(spacing.beam_step_rad) * spacing.median_range_m;
  return std::atan2(step_m, kNoiseSteps * spacing.noise_m) / kDegree;
}

std::string millimetres(double metres) { return number(1e3 * metres, 0) + " mm"; }

}  // namespace

ModelerConfig adapted(ModelerConfig preset, const LineSpacing& spacing) {
  const double coarser = std::max(1.0, spacing.beam_step_rad / kBeamStepOfPr2_rad);
  ScanConfig& scan = preset.scan;
  scan.range_sigma_m = std::max(scan.range_sigma_m, rounded_up(spacing.noise_m, 1000.0));
  scan.direction_sigma_deg = to_hundredths(spacing.beam_step_rad / kDegree / std::sqrt(12.0));
  if (lines_are_within_noise(spacing)) {
    // Base lines are as long as the noise asks for: more than there is costs the ribbons of small
    // surfaces.
    scan.range_sigma_m = rounded_up(kMuchNoise * spacing.noise_m, 1000.0);
    scan.base_line_sigmas = std::max(scan.base_line_sigmas, kAveragingBaseLine);
  }
  scan.mixed_pixel_angle_deg = std::min(
      scan.mixed_pixel_angle_deg, std::floor(10.0 * max_mixed_pixel_angle_deg(spacing)) / 10.0);
  RibbonConfig& ribbon = preset.ribbon;
  ribbon.neighbourhood_m = to_hundredths(ribbon.neighbourhood_m * std::sqrt(coarser));
  ribbon.min_length_m = to_hundredths(ribbon.min_length_m * std::sqrt(coarser));
  const int points = static_cast<int>(std::lround(ribbon.min_points / std::sqrt(coarser)));
  ribbon.min_points = std::min(ribbon.min_points, std::max(4, points));
  SurfaceConfig& surface = preset.surface;
  const double gap_m = std::max(spacing.line_gap_m(), spacing.beam_gap_m());
  if (gap_m > surface.cell_size_m) {
    surface.cell_size_m = std::min(kMaxCell_m, rounded_up(kObliqueGaps * gap_m, 100.0));
    surface.outline_tolerance_m = rounded_up(surface.cell_size_m * std::sqrt(0.5), 1000.0);
  }
  surface.stripe_gap_m = std::max(
      surface.stripe_gap_m, rounded_up(2.0 * spacing.line_step_rad * spacing.far_range_m, 10.0));
  const double lines_of_a_small_plane =
      std::sqrt(preset.assembly.min_area_m2) / std::max(1e-6, spacing.line_gap_m());
  for (int* min_ribbons : {&preset.assembly.min_ribbons, &preset.registration.min_ribbons}) {
    const int lines = static_cast<int>(std::min(lines_of_a_small_plane, 1e6));
    *min_ribbons = std::min(*min_ribbons, std::max(kMinRibbons, lines));
  }
  return preset;
}

void report_spacing(const LineSpacing& spacing, const ModelerConfig& preset, BagReport& report) {
  const double noise_m = spacing.noise_m;
  if (spacing.line_step_rad <= 0.0 || spacing.median_range_m <= 0.0) return;
  const std::string facts = "lines are " + degrees(spacing.line_step_rad, 2) + " degrees apart, " +
                            millimetres(spacing.line_step_rad * spacing.median_range_m) +
                            " at the median range; the noise of a range is about " +
                            millimetres(noise_m);
  constexpr const char* how = ": `bag_check --propose-preset FILE` writes a preset";
  if (lines_are_within_noise(spacing) && preset.scan.base_line_sigmas < kAveragingBaseLine) {
    report.warning(facts +
                   ": closer than the noise. Lines are averaged; a preset with "
                   "scan.base_line_sigmas 3 (config/urg04lx.yaml) makes the most of them");
  } else {
    report.fact(facts);
  }
  const double gap_m = std::max(spacing.line_gap_m(), spacing.beam_gap_m());
  if (gap_m > preset.surface.cell_size_m) {
    report.warning("at " + number(spacing.far_range_m, 1) + " m, lines are " +
                   millimetres(spacing.line_gap_m()) + " apart and beams " +
                   millimetres(spacing.beam_gap_m()) + ": coarse. Cells of surface.cell_size_m (" +
                   millimetres(preset.surface.cell_size_m) +
                   ") stay empty, and surfaces get holes; see also ribbon.neighbourhood_m, "
                   "ribbon.min_points and assembly.min_ribbons" +
                   how);
  }
  if (noise_m > kMuchNoise * preset.scan.range_sigma_m) {
    report.warning("the noise of a range is about " + millimetres(noise_m) +
                   ", but scan.range_sigma_m is " + millimetres(preset.scan.range_sigma_m) +
                   ": ribbons are refused as too thick" + how);
  }
  if (preset.scan.mixed_pixel_angle_deg > max_mixed_pixel_angle_deg(spacing)) {
    report.warning("beams are " + degrees(spacing.beam_step_rad, 3) +
                   " degrees apart, so close that noise looks like mixed pixels with "
                   "scan.mixed_pixel_angle_deg " +
                   number(preset.scan.mixed_pixel_angle_deg, 1) + how);
  }
}

}  // namespace ribbon_mapper
