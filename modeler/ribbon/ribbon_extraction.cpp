// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/ribbon_extraction.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/geometry/square.hpp"

namespace ribbon_mapper {
namespace {

constexpr double degree = M_PI / 180.0;

Moments three_lines(const LineBuffer& buffer, std::size_t begin, std::size_t end) {
  return buffer.previous().moments(begin, end) + buffer.middle().moments(begin, end) +
         buffer.next().moments(begin, end);
}

/// Beams that a run's plane is estimated from: a short run's middle lends its neighbourhood. Empty
/// if it has none.
Neighbourhood support_of(const LineBuffer& buffer, Neighbourhood run, const RibbonConfig& config) {
  if (run.size() >= 2 * static_cast<std::size_t>(config.min_points)) return run;
  const Neighbourhood around =
      neighbourhood_of(buffer, (run.begin + run.end) / 2, config.neighbourhood_m);
  if (around.size() == 0) return {};
  return {std::min(run.begin, around.begin), std::max(run.end, around.end)};
}

/// -1 if the plane's normal looks away from the sensor.
double side_of(const ScanLine& line, std::size_t beam, const PlaneFit& plane) {
  return plane.normal().dot(line.directions[beam]) > 0.0 ? -1.0 : 1.0;
}

/// Calls function(begin, end) for successive stretches of a run, each as long as a sample.
template <typename Function>
void for_each_stretch(const ScanLine& line, std::size_t begin, std::size_t run_end, double length_m,
                      const Function& function) {
  const double square_m2 = length_m * length_m;
  while (begin < run_end) {
    std::size_t end = begin + 1;
    while (end < run_end && (line.points[end] - line.points[begin]).squaredNorm() < square_m2) {
      ++end;
    }
    function(begin, end);
    begin = end;
  }
}

}  // namespace

RibbonExtraction::RibbonExtraction(const ScanConfig& scan, const RibbonConfig& config)
    : scan_(scan), config_(config), clusters_(config) {}

const std::vector<Ribbon>& RibbonExtraction::extract(const LineBuffer& buffer, PointStore& store) {
  const ScanLine& line = buffer.middle();
  sensor_origin_ = line.origin(line.size() / 2);
  estimate_surfels(buffer, scan_, config_, surfels_);
  clusters_.classify(surfels_, sensor_origin_);
  find_runs(line);
  ribbons_.clear();
  taken_.assign(line.size(), 0);
  for (const Run& run : runs_) make_ribbon(buffer, run, store);
  std::sort(ribbons_.begin(), ribbons_.end(),
            [](const Ribbon& a, const Ribbon& b) { return a.first_beam < b.first_beam; });
  return ribbons_;
}

/// Surfels of one cluster that follow each other on one segment of the line.
void RibbonExtraction::find_runs(const ScanLine& line) {
  runs_.clear();
  const std::vector<int>& cluster = clusters_.of_surfels();
  for (std::size_t i = 0; i < surfels_.size();) {
    Run run{surfels_[i].beam, surfels_[i].beam + 1u, surfels_[i].area_m2};
    std::size_t next = i + 1;
    for (; next < surfels_.size() && cluster[next] == cluster[i]; ++next) {
      if (surfels_[next].beam >= line.end_of_segment[run.begin]) break;
      run.end = surfels_[next].beam + 1u;
      run.area_m2 += surfels_[next].area_m2;
    }
    if (cluster[i] != SurfelClusters::none) runs_.push_back(run);
    i = next;
  }
  std::sort(runs_.begin(), runs_.end(), [](const Run& a, const Run& b) {
    return a.area_m2 != b.area_m2 ? a.area_m2 > b.area_m2 : a.begin < b.begin;
  });
}

/// Within so many sigma of what errors of the range and of the direction do across the plane. At a
/// slant next to nothing is left of the range's, and the foot of the wall behind is told from
/// noise.
bool RibbonExtraction::lies_on(const PlaneFit& plane, const ScanLine& line,
                               std::size_t beam) const {
  const double distance = plane.normal().dot(line.points[beam] - plane.mean);
  const double square_sine = square(plane.normal().dot(line.directions[beam]));
  const double direction_sigma_m = scan_.direction_sigma_deg * degree * line.ranges_m[beam];
  const double variance =
      square_sine * square(scan_.range_sigma_m) + (1.0 - square_sine) * square(direction_sigma_m);
  return square(distance) <= square(config_.outlier_sigmas) * variance;
}

/// Takes in the points next to a run while they lie on its plane.
RibbonExtraction::Run RibbonExtraction::grow(const ScanLine& line, Run run,
                                             const PlaneFit& plane) const {
  const auto fits = [&](std::size_t beam) { return !taken_[beam] && lies_on(plane, line, beam); };
  const std::size_t first = line.first_of_segment[run.begin];
  const std::size_t end = line.end_of_segment[run.begin];
  while (run.begin > first && fits(run.begin - 1)) --run.begin;
  while (run.end < end && fits(run.end)) ++run.end;
  while (run.begin < run.end && !fits(run.begin)) ++run.begin;
  while (run.end > run.begin && !fits(run.end - 1)) --run.end;
  return run;
}

/// Where the three lines straddle an edge, their common plane is a blend of both faces and the
/// middle line lies off it; on a plane its mean differs from it by noise alone.
bool RibbonExtraction::straddles_an_edge(const LineBuffer& buffer, const Run& core,
                                         const PlaneFit& plane) const {
  const Moments middle = buffer.middle().moments(core.begin, core.end);
  const double offset = std::abs(plane.normal().dot(middle.mean() - plane.mean));
  const double standard_error = std::sqrt(plane.variances[0] * 1.5 / middle.weight());
  return offset > config_.spurious_sigmas * standard_error + config_.spurious_slack_m;
}

void RibbonExtraction::make_ribbon(const LineBuffer& buffer, const Run& run, PointStore& store) {
  const ScanLine& line = buffer.middle();
  const Neighbourhood support = support_of(buffer, {run.begin, run.end}, config_);
  if (support.size() == 0) return;
  Run core{support.begin, support.end, run.area_m2};
  const Moments all = three_lines(buffer, core.begin, core.end);
  const PlaneFit plane = fit_plane(all);
  const double noise = config_.outlier_sigmas * scan_.range_sigma_m;
  if (plane.variances[0] > noise * noise || straddles_an_edge(buffer, core, plane)) return;
  core = grow(line, core, plane);
  if (core.end < core.begin + static_cast<std::size_t>(config_.min_points)) return;

  const std::size_t centre = (core.begin + core.end) / 2;
  const double incidence = std::abs(plane.normal().dot(line.directions[centre]));
  if (incidence < std::sin(config_.min_grazing_angle_deg * degree)) return;

  const Pose T_base_odom = line.T_odom_base.inverse(Eigen::Isometry);
  Ribbon ribbon;
  ribbon.first_beam = static_cast<std::uint32_t>(core.begin);
  ribbon.last_beam = static_cast<std::uint32_t>(core.end - 1);
  const Eigen::Vector3d chord = line.points[core.end - 1] - line.points[core.begin];
  if (chord.norm() < config_.min_length_m) return;
  const Eigen::Vector3d normal = side_of(line, core.begin, plane) * plane.normal();
  const Eigen::Vector3d along = (chord - normal.dot(chord) * normal).normalized();
  ribbon.normal = (T_base_odom.linear() * normal).cast<float>();
  ribbon.along = (T_base_odom.linear() * along).cast<float>();
  const Eigen::Vector3d across = plane.normal().cross(chord).normalized();
  const double base_line_m = std::sqrt(across.dot(all.covariance() * across));
  ribbon.sigma_across_rad =
      static_cast<float>(std::sqrt(plane.variances[0] / all.weight()) / base_line_m);
  Moments moments = line.moments(core.begin, core.end);
  moments.spread(base_line_m * across);
  ribbon.spread = moments.transformed(T_base_odom);
  std::fill(taken_.begin() + core.begin, taken_.begin() + core.end, 1);
  ribbon.area_m2 =
      static_cast<float>(capped_area_m2(buffer, {core.begin, core.end}, config_.area_cap_m2));
  ribbon.samples = samples_of(line, core, moments.mean(), normal, along, store);
  ribbon.length_m = ribbon.samples.length_m();
  ribbons_.push_back(ribbon);
}

RibbonSamples RibbonExtraction::samples_of(const ScanLine& line, const Run& run,
                                           const Eigen::Vector3d& centroid,
                                           const Eigen::Vector3d& normal,
                                           const Eigen::Vector3d& along, PointStore& store) {
  const double d_m = -normal.dot(centroid);
  for_each_stretch(line, run.begin, run.end, config_.sample_length_m,
                   [&](std::size_t begin, std::size_t end) {
                     const Moments moments = line.moments(begin, end);
                     const Eigen::Vector3d mean = moments.mean();
                     packer_.add(along.dot(mean - centroid), normal.dot(mean) + d_m,
                                 moments.mean_square_distance(normal, d_m), end - begin);
                   });
  RibbonSamples samples = packer_.pack();
  samples.first = store.samples.keep(samples.first, samples.size);
  return samples;
}

void RibbonExtraction::collect_unassigned(const ScanLine& line) {
  unassigned_.clear();
  const auto is_unassigned = [&](std::size_t beam) {
    return line.has_return(beam) && !taken_[beam];
  };
  for (std::size_t begin = 0; begin < line.size(); ++begin) {
    if (!is_unassigned(begin)) continue;
    std::size_t run_end = begin + 1;
    while (run_end < line.end_of_segment[begin] && is_unassigned(run_end)) ++run_end;
    for_each_stretch(
        line, begin, run_end, config_.sample_length_m, [&](std::size_t first, std::size_t end) {
          unassigned_.push_back({line.moments(first, end).mean() - sensor_origin_, end - first});
        });
    begin = run_end - 1;
  }
}

UnassignedPoints RibbonExtraction::unassigned(const LineBuffer& buffer, PointStore& store) {
  const ScanLine& line = buffer.middle();
  collect_unassigned(line);
  const Pose T_base_odom = line.T_odom_base.inverse(Eigen::Isometry);
  UnassignedPoints unassigned;
  unassigned.sensor = (T_base_odom * sensor_origin_).cast<float>();
  double max_m = 0.0;
  for (const Stray& stray : unassigned_) {
    max_m = std::max(max_m, stray.from_sensor.cwiseAbs().sum());  // more than any of its turns
  }
  unassigned.step_m =
      std::max(unassigned.step_m, static_cast<float>(max_m / UnassignedPoints::max_steps));
  packed_unassigned_.clear();
  for (const Stray& stray : unassigned_) {
    const Eigen::Vector3d steps = T_base_odom.linear() * stray.from_sensor / unassigned.step_m;
    PackedPoint packed;
    for (int i = 0; i < 3; ++i) {
      packed.from_sensor[i] = static_cast<std::int16_t>(std::lround(steps[i]));
    }
    packed.count =
        static_cast<std::uint16_t>(std::min<std::size_t>(stray.count, UnassignedPoints::max_count));
    packed_unassigned_.push_back(packed);
  }
  unassigned.size = static_cast<std::uint32_t>(packed_unassigned_.size());
  unassigned.first = store.unassigned.keep(packed_unassigned_.data(), packed_unassigned_.size());
  return unassigned;
}

}  // namespace ribbon_mapper
