// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/lines/noise_scale.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/geometry/square.hpp"
#include "modeler/registration/trajectory_segment.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr double kSpan_s = 2.0;
// As many spans as 20 s of driving: by then, the data decide.
constexpr double kPriorSpans = 10.0;
// Part of the odometry's squared error that adjusted poses show: the rest they share with it. It
// was measured at 0.6 to 0.7 where the noise is known.
constexpr double kShownPart = 0.65;
// A slip is no noise: beyond five standard deviations at the scale so far, a span counts as five.
constexpr double kMaxSigmas = 5.0;
// The PR2's wheels are encoded to 0.1 % of the way, a tenth of gmapping's figure.
constexpr double kMinScale = 0.1;

/// Returns true if the base stands still by odometry.
bool is_still(const TrajectorySegment& span) {
  double way = 0.0;
  for (const Pose& step : span.steps) way += step.translation().norm() + angle_of(step);
  return way < 1e-3;
}

}  // namespace

double NoiseScale::Mean::value() const {
  return std::sqrt((kPriorSpans * square(assumed_) + square_sum_) / (kPriorSpans + spans_));
}

void NoiseScale::Mean::add(double measured) {
  const double plausible = std::min(measured, kMaxSigmas * value());
  square_sum_ += std::max(square(kMinScale), square(plausible) / kShownPart);
  spans_ += 1.0;
}

OdometryNoise NoiseScale::noise() const {
  OdometryNoise noise;
  noise.planar_scale = planar_.value();
  noise.spatial_scale = spatial_.value();
  return noise;
}

void NoiseScale::learn(const PosedLines& lines, std::uint32_t first, std::uint32_t end) {
  std::uint32_t start = first;
  for (std::uint32_t i = first; i < end; ++i) {
    if (lines.seconds_between(start, i) < kSpan_s) continue;
    TrajectorySegment span;
    bool has_slip = false;
    for (std::uint32_t k = start + 1; k <= i; ++k) {
      span.steps.push_back(lines.recorded_step(k));
      has_slip = has_slip || lines.is_slip(k);
    }
    span.T_frame_start = lines.T_start_base(start), span.T_frame_end = lines.T_start_base(i);
    start = i;
    if (has_slip || is_still(span)) continue;
    const OdometryNoise fitted = fitted_noise({span});
    planar_.add(fitted.planar_scale);
    spatial_.add(fitted.spatial_scale);
  }
}

}  // namespace ribbon_mapper::slam
