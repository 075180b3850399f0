// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/surfel.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/geometry/plane_fit.hpp"

namespace ribbon_mapper {
namespace {

constexpr std::int64_t kMinHalfWidth = 2;  // beams
constexpr double kMaxHalfWidth = 1e6;      // beams; reached only if all of them hit one spot

/// Beams of the middle line.
struct Segment {
  std::int64_t first, end;
};

/// Returns the beams around `beam` that lie on one segment in each of the three lines.
inline Segment segment_of(const ThreeLines& lines, std::size_t beam) {
  const ScanLine &previous = lines.previous, &middle = lines.middle, &next = lines.next;
  if (lines.are_matched_by_index()) {
    return {std::max({previous.first_of_segment[beam], middle.first_of_segment[beam],
                      next.first_of_segment[beam]}),
            std::min({previous.end_of_segment[beam], middle.end_of_segment[beam],
                      next.end_of_segment[beam]})};
  }
  const BeamMatch &to_previous = lines.to_previous, &to_next = lines.to_next;
  return {std::max({to_previous.first_of_segment(beam), to_next.first_of_segment(beam),
                    std::int64_t{middle.first_of_segment[beam]}}),
          std::min({to_previous.end_of_segment(beam), to_next.end_of_segment(beam),
                    std::int64_t{middle.end_of_segment[beam]}})};
}

BeamRange around(const ThreeLines& lines, std::size_t beam, double half_length_m) {
  if (!lines.have_return(beam)) return {};
  const ScanLine& middle = lines.middle;
  const double spacing_m = middle.ranges_m[beam] * std::abs(middle.angle_increment_rad);
  const auto half = std::max<std::int64_t>(
      kMinHalfWidth, static_cast<std::int64_t>(std::min(half_length_m / spacing_m, kMaxHalfWidth)));
  const auto here = static_cast<std::int64_t>(beam);
  const auto [first_of_segments, end_of_segments] = segment_of(lines, beam);
  const std::int64_t begin = std::max(here - half, first_of_segments);
  const std::int64_t end = std::min(here + half + 1, end_of_segments);
  if (end - begin < 2 * kMinHalfWidth) return {};
  return {static_cast<std::size_t>(begin), static_cast<std::size_t>(end)};
}

/// Returns the step from the previous line to the next, as the difference of unit directions, where
/// beams are matched by bearing.
[[gnu::cold]] Eigen::Vector3d steps_by_bearing(const ThreeLines& lines, std::size_t beam) {
  return lines.to_next.direction(beam) - lines.to_previous.direction(beam);
}

inline double area_m2(const ThreeLines& lines, std::size_t beam, bool by_index) {
  const double range = lines.middle.ranges_m[beam];
  const double square =
      by_index ? (lines.next.directions[beam] - lines.previous.directions[beam]).squaredNorm()
               : steps_by_bearing(lines, beam).squaredNorm();
  const double half_step_sine = 0.25 * std::sqrt(square);  // of two steps
  return 4.0 * range * range * half_step_sine * lines.middle.half_increment_sine;
}

/// Limits the thickness to what noise explains, and asks for a base line wider than that.
Flatness flatness_of(const ScanConfig& scan, const RibbonConfig& config) {
  const double limit_m = config.outlier_sigmas * scan.range_sigma_m;
  return {limit_m * limit_m, 2.0};
}

/// Estimates point and normal, not the area. Returns false if the points make no normal.
bool estimate(const ThreeLines& lines, std::size_t beam, const BeamRange& near,
              const Flatness& flatness, Surfel& surfel) {
  const Moments middle = lines.middle.moments(near.begin, near.end);
  const auto normal = flat_normal(middle + lines.to_previous.moments(near.begin, near.end) +
                                      lines.to_next.moments(near.begin, near.end),
                                  flatness);
  if (!normal) return false;
  surfel.beam = static_cast<std::uint32_t>(beam);
  surfel.point = middle.mean();
  const double side = normal->dot(lines.middle.directions[beam]) > 0.0 ? -1.0 : 1.0;
  surfel.normal = side * *normal;
  return true;
}

}  // namespace

BeamRange neighbourhood_of(const ThreeLines& lines, std::size_t beam, double half_length_m) {
  return around(lines, beam, half_length_m);
}

double surfel_area_m2(const ThreeLines& lines, std::size_t beam) {
  return area_m2(lines, beam, lines.are_matched_by_index());
}

double capped_area_m2(const ThreeLines& lines, const BeamRange& beams, double cap_m2) {
  const auto sum_m2 = [&](bool by_index) {
    double sum = 0.0;
    for (std::size_t beam = beams.begin; beam < beams.end; ++beam) {
      sum += std::min(cap_m2, area_m2(lines, beam, by_index));
    }
    return sum;
  };
  return lines.are_matched_by_index() ? sum_m2(true) : sum_m2(false);  // two loops, without tests
}

void estimate_surfels(const ThreeLines& lines, const ScanConfig& scan, const RibbonConfig& config,
                      std::vector<Surfel>& surfels) {
  surfels.clear();
  const Flatness flatness = flatness_of(scan, config);
  const bool by_index = lines.are_matched_by_index();
  Surfel surfel;
  for (std::size_t beam = 0; beam < lines.middle.size();) {
    if (!lines.middle.has_return(beam)) {
      ++beam;
      continue;
    }
    const BeamRange near = around(lines, beam, config.neighbourhood_m);
    const std::size_t stride = std::max<std::size_t>(1, near.size() / 8);
    if (near.size() > 0 && estimate(lines, beam, near, flatness, surfel)) {
      surfel.area_m2 = std::min(config.area_cap_m2, area_m2(lines, beam, by_index)) *
                       static_cast<double>(stride);
      surfels.push_back(surfel);
    }
    beam += stride;
  }
}

}  // namespace ribbon_mapper
