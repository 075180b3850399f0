// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/surfel.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ribbon_mapper {
namespace {

constexpr std::size_t least_half_width = 2;  // beams

std::size_t half_width(const ScanLine& line, std::size_t beam, double half_length_m) {
  const double spacing_m = line.ranges_m[beam] * std::abs(line.angle_increment_rad);
  return std::max(least_half_width, static_cast<std::size_t>(half_length_m / spacing_m));
}

/// Largest variance across the plane that noise explains.
double noise_limit_m2(const ScanConfig& scan, const RibbonConfig& config) {
  const double limit = config.outlier_sigmas * scan.range_sigma_m;
  return limit * limit;
}

std::optional<Surfel> estimate(const LineBuffer& buffer, std::size_t beam,
                               const Neighbourhood& around, double variance_limit_m2) {
  const Moments middle = buffer.middle().moments(around.begin, around.end);
  const PlaneFit fit = fit_plane(middle + buffer.previous().moments(around.begin, around.end) +
                                 buffer.next().moments(around.begin, around.end));
  // On a plane the smaller extent is that of the base line; no wider than thick means no normal.
  if (fit.variances[0] > variance_limit_m2 || fit.variances[1] < 2.0 * fit.variances[0]) {
    return std::nullopt;
  }
  Surfel surfel;
  surfel.beam = static_cast<std::uint32_t>(beam);
  surfel.point = middle.mean();
  surfel.normal = fit.normal();
  if (surfel.normal.dot(buffer.middle().directions[beam]) > 0.0) surfel.normal *= -1.0;
  return surfel;
}

}  // namespace

Neighbourhood neighbourhood_of(const LineBuffer& buffer, std::size_t beam, double half_length_m) {
  const std::size_t half = half_width(buffer.middle(), beam, half_length_m);
  std::size_t begin = beam > half ? beam - half : 0;
  std::size_t end = beam + half + 1;
  for (const ScanLine* line : {&buffer.previous(), &buffer.middle(), &buffer.next()}) {
    if (!line->has_return(beam)) return {};
    begin = std::max<std::size_t>(begin, line->first_of_segment[beam]);
    end = std::min<std::size_t>(end, line->end_of_segment[beam]);
  }
  if (end - begin < 2 * least_half_width) return {};
  return {begin, end};
}

double surfel_area_m2(const LineBuffer& buffer, std::size_t beam) {
  const double range = buffer.middle().ranges_m[beam];
  const Eigen::Vector3d& before = buffer.previous().directions[beam];
  const Eigen::Vector3d& after = buffer.next().directions[beam];
  const double half_step_sine = 0.25 * (after - before).norm();  // chord of two steps
  return 4.0 * range * range * half_step_sine * buffer.middle().half_increment_sine;
}

void estimate_surfels(const LineBuffer& buffer, const ScanConfig& scan, const RibbonConfig& config,
                      std::vector<Surfel>& surfels) {
  surfels.clear();
  const ScanLine& line = buffer.middle();
  const double limit = noise_limit_m2(scan, config);
  for (std::size_t beam = 0; beam < line.size();) {
    if (!line.has_return(beam)) {
      ++beam;
      continue;
    }
    const Neighbourhood around = neighbourhood_of(buffer, beam, config.neighbourhood_m);
    const std::size_t stride = std::max<std::size_t>(1, around.size() / 8);
    if (around.size() > 0) {
      if (auto surfel = estimate(buffer, beam, around, limit)) {
        surfel->area_m2 = std::min(config.area_cap_m2, surfel_area_m2(buffer, beam)) * stride;
        surfels.push_back(*surfel);
      }
    }
    beam += stride;
  }
}

}  // namespace ribbon_mapper
