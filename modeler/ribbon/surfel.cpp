// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/surfel.hpp"

#include <algorithm>
#include <cmath>

namespace ribbon_mapper {
namespace {

constexpr std::int64_t min_half_width = 2;  // beams
constexpr double max_half_width = 1e6;      // of beams that all lie on one spot

/// The lines of a buffer, with what does not change from beam to beam.
struct Lines {
  explicit Lines(const LineBuffer& buffer)
      : previous(buffer.previous()),
        middle(buffer.middle()),
        next(buffer.next()),
        beam_spacing(std::abs(middle.angle_increment_rad)) {}

  const ScanLine &previous, &middle, &next;
  double beam_spacing;  ///< per metre of range
};

Neighbourhood around(const Lines& lines, std::size_t beam, double half_length_m) {
  const auto& [previous, middle, next, beam_spacing] = lines;
  if (!previous.has_return(beam) || !middle.has_return(beam) || !next.has_return(beam)) return {};
  const double spacing_m = middle.ranges_m[beam] * beam_spacing;
  const auto half = std::max<std::int64_t>(
      min_half_width,
      static_cast<std::int64_t>(std::min(half_length_m / spacing_m, max_half_width)));
  const auto here = static_cast<std::int64_t>(beam);
  const std::int64_t first_of_segments =
      std::max({previous.first_of_segment[beam], middle.first_of_segment[beam],
                next.first_of_segment[beam]});
  const std::int64_t end_of_segments = std::min(
      {previous.end_of_segment[beam], middle.end_of_segment[beam], next.end_of_segment[beam]});
  const std::int64_t begin = std::max(here - half, first_of_segments);
  const std::int64_t end = std::min(here + half + 1, end_of_segments);
  if (end - begin < 2 * min_half_width) return {};
  return {static_cast<std::size_t>(begin), static_cast<std::size_t>(end)};
}

inline double area_m2(const Lines& lines, std::size_t beam) {
  const double range = lines.middle.ranges_m[beam];
  const Eigen::Vector3d& before = lines.previous.directions[beam];
  const Eigen::Vector3d& after = lines.next.directions[beam];
  const double half_step_sine = 0.25 * std::sqrt((after - before).squaredNorm());  // of two steps
  return 4.0 * range * range * half_step_sine * lines.middle.half_increment_sine;
}

/// No thicker than noise explains. The smaller extent is that of the base line: no wider than thick
/// means no normal.
Flatness flatness_of(const ScanConfig& scan, const RibbonConfig& config) {
  const double limit_m = config.outlier_sigmas * scan.range_sigma_m;
  return {limit_m * limit_m, 2.0};
}

/// All but the area; false if the points make no normal.
bool estimate(const Lines& lines, std::size_t beam, const Neighbourhood& near,
              const Flatness& flatness, Surfel& surfel) {
  const Moments middle = lines.middle.moments(near.begin, near.end);
  const auto normal = flat_normal(middle + lines.previous.moments(near.begin, near.end) +
                                      lines.next.moments(near.begin, near.end),
                                  flatness);
  if (!normal) return false;
  surfel.beam = static_cast<std::uint32_t>(beam);
  surfel.point = middle.mean();
  const double side = normal->dot(lines.middle.directions[beam]) > 0.0 ? -1.0 : 1.0;
  surfel.normal = side * *normal;
  return true;
}

}  // namespace

Neighbourhood neighbourhood_of(const LineBuffer& buffer, std::size_t beam, double half_length_m) {
  return around(Lines(buffer), beam, half_length_m);
}

double surfel_area_m2(const LineBuffer& buffer, std::size_t beam) {
  return area_m2(Lines(buffer), beam);
}

double capped_area_m2(const LineBuffer& buffer, const Neighbourhood& beams, double cap_m2) {
  const Lines lines(buffer);
  double sum_m2 = 0.0;
  for (std::size_t beam = beams.begin; beam < beams.end; ++beam) {
    sum_m2 += std::min(cap_m2, area_m2(lines, beam));
  }
  return sum_m2;
}

void estimate_surfels(const LineBuffer& buffer, const ScanConfig& scan, const RibbonConfig& config,
                      std::vector<Surfel>& surfels) {
  surfels.clear();
  const Lines lines(buffer);
  const Flatness flatness = flatness_of(scan, config);
  Surfel surfel;
  for (std::size_t beam = 0; beam < lines.middle.size();) {
    if (!lines.middle.has_return(beam)) {
      ++beam;
      continue;
    }
    const Neighbourhood near = around(lines, beam, config.neighbourhood_m);
    const std::size_t stride = std::max<std::size_t>(1, near.size() / 8);
    if (near.size() > 0 && estimate(lines, beam, near, flatness, surfel)) {
      surfel.area_m2 =
          std::min(config.area_cap_m2, area_m2(lines, beam)) * static_cast<double>(stride);
      surfels.push_back(surfel);
    }
    beam += stride;
  }
}

}  // namespace ribbon_mapper
