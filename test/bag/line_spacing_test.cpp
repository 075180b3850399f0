// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/line_spacing.hpp"

#include <gmock/gmock.h>

#include "modeler/geometry/angles.hpp"

namespace ribbon_mapper {
namespace {

using testing::HasSubstr;

/// Returns the spacing of a PR2 in a room.
LineSpacing pr2() {
  LineSpacing spacing;
  spacing.line_step_rad = 0.02, spacing.beam_step_rad = 0.25 * kDegree;
  spacing.sweeps = 5.0, spacing.noise_m = 0.01;
  spacing.median_range_m = 3.0, spacing.far_range_m = 5.0;
  return spacing;
}

std::string warnings(const LineSpacing& spacing, const ModelerConfig& preset = {}) {
  BagReport report;
  report_spacing(spacing, preset, report);
  std::string text;
  for (const Finding& finding : report.findings()) {
    if (finding.weight == Finding::Weight::warning) text += finding.text + "\n";
  }
  return text;
}

TEST(LineSpacing, OfThePr2NeedsNoOtherPreset) {
  EXPECT_EQ("", warnings(pr2()));
  const ModelerConfig preset, changed = adapted(preset, pr2());
  EXPECT_EQ(preset.surface.cell_size_m, changed.surface.cell_size_m);
  EXPECT_EQ(preset.ribbon.neighbourhood_m, changed.ribbon.neighbourhood_m);
  EXPECT_EQ(preset.ribbon.min_points, changed.ribbon.min_points);
  EXPECT_EQ(preset.assembly.min_ribbons, changed.assembly.min_ribbons);
}

TEST(LineSpacing, ProposedLengthsAreReadable) {
  LineSpacing spacing = pr2();
  spacing.far_range_m = 7.0;
  EXPECT_EQ(0.3, adapted({}, spacing).surface.stripe_gap_m);  // not 0.30000000000000004
}

/// Expects a warning with these words, and none with the adapted preset.
void expect_mended(const LineSpacing& spacing, const char* words) {
  EXPECT_THAT(warnings(spacing), HasSubstr(words));
  EXPECT_EQ("", warnings(spacing, adapted({}, spacing)));
  adapted({}, spacing).validate();
}

TEST(LineSpacing, OfLinesFarApart) {
  LineSpacing spacing = pr2();
  spacing.sweeps = 1.0;
  expect_mended(spacing, "lines are 100 mm apart and beams 22 mm: coarse");
}

TEST(LineSpacing, OfBeamsFarApart) {
  LineSpacing spacing = pr2();
  spacing.beam_step_rad = 1.0 * kDegree;
  expect_mended(spacing, "beams 87 mm: coarse");
  const ModelerConfig changed = adapted({}, spacing);
  EXPECT_DOUBLE_EQ(0.3, changed.ribbon.neighbourhood_m);  // four times the step: twice the length
  EXPECT_EQ(4, changed.ribbon.min_points);
  EXPECT_DOUBLE_EQ(0.29, changed.scan.direction_sigma_deg);
}

TEST(LineSpacing, OfLinesCloserThanTheNoise) {
  LineSpacing spacing = pr2();
  spacing.line_step_rad = 0.001;
  expect_mended(spacing, "scan.base_line_sigmas 3");
}

TEST(LineSpacing, OfBeamsCloserThanTheNoise) {
  LineSpacing spacing = pr2();
  spacing.beam_step_rad = 0.03 * kDegree;
  expect_mended(spacing, "scan.mixed_pixel_angle_deg 4.0");
}

TEST(LineSpacing, OfARangeWithMoreNoise) {
  LineSpacing spacing = pr2();
  spacing.noise_m = 0.04;
  expect_mended(spacing, "the noise of a range is about 40 mm, but scan.range_sigma_m is 18 mm");
}

}  // namespace
}  // namespace ribbon_mapper
