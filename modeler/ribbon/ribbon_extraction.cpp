// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ribbon/ribbon_extraction.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "modeler/geometry/angles.hpp"
#include "modeler/geometry/square.hpp"
#include "modeler/ribbon/bend.hpp"

namespace ribbon_mapper {
namespace {

/// Variance of the difference between the middle line's mean and that of the two other lines, in
/// units of the variance of one line's mean: 1 + 1/2. The middle line's offset from the plane of
/// all three lines is two thirds of that difference, so the test errs on the side of keeping
/// ribbons.
constexpr double kMiddleLineVarianceFactor = 1.5;

/// Returns -1 if the plane's normal points away from the sensor, else 1.
double side_of(const ScanLine& line, std::size_t beam, const PlaneFit& plane) {
  return plane.normal().dot(line.directions[beam]) > 0.0 ? -1.0 : 1.0;
}

/// Calls function(begin, end) for successive stretches of beams, each as long as a sample.
template <typename Function>
void for_each_stretch(const ScanLine& line, std::size_t begin, std::size_t end_of_all,
                      double length_m, const Function& function) {
  const double square_m2 = length_m * length_m;
  while (begin < end_of_all) {
    std::size_t end = begin + 1;
    while (end < end_of_all && (line.points[end] - line.points[begin]).squaredNorm() < square_m2) {
      ++end;
    }
    function(begin, end);
    begin = end;
  }
}

}  // namespace

RibbonExtraction::RibbonExtraction(const ScanConfig& scan, const RibbonConfig& config)
    : scan_(scan), config_(config), clusters_(config) {}

const LineObservations& RibbonExtraction::extract(const ThreeLines& lines) {
  const ScanLine& line = lines.middle;
  sensor_origin_ = line.origin(line.size() / 2);
  estimate_surfels(lines, scan_, config_, surfels_);
  clusters_.classify(surfels_, sensor_origin_);
  find_runs(line);
  result_.ribbons.clear();
  samples_.clear();
  is_taken_.assign(line.size(), 0);
  for (const Run& run : runs_) add_ribbon(lines, run);
  link_samples();
  find_left_over(line);
  pack_left_over(line);
  return result_;
}

/// Finds the runs of surfels of one cluster on one segment of the line; the largest come first.
void RibbonExtraction::find_runs(const ScanLine& line) {
  runs_.clear();
  const std::vector<int>& cluster = clusters_.of_surfels();
  for (std::size_t i = 0; i < surfels_.size();) {
    const std::size_t beam = surfels_[i].beam;
    const BeamRange segment{line.first_of_segment[beam], line.end_of_segment[beam]};
    std::size_t next = i + 1;
    while (next < surfels_.size() && cluster[next] == cluster[i] &&
           surfels_[next].beam < segment.end) {
      ++next;
    }
    if (cluster[i] != SurfelClusters::kNone) add_run(line, i, next, segment);
    i = next;
  }
  std::sort(runs_.begin(), runs_.end(), [](const Run& a, const Run& b) {
    return a.area_m2 != b.area_m2 ? a.area_m2 > b.area_m2 : a.beams.begin < b.beams.begin;
  });
}

/// Adds the run of these surfels, or those of its pieces if it bends.
void RibbonExtraction::add_run(const ScanLine& line, std::size_t first_surfel,
                               std::size_t end_of_surfels, const BeamRange& room) {
  const auto surfel = surfels_.begin();
  const auto first = surfel + static_cast<std::ptrdiff_t>(first_surfel);
  const auto end = surfel + static_cast<std::ptrdiff_t>(end_of_surfels);
  if (first == end) return;
  const BeamRange beams{first->beam, std::prev(end)->beam + 1U};
  if (const auto bend = find_bend(line, beams, scan_, config_)) {
    const auto at = std::find_if(first, end, [&](const Surfel& s) { return s.beam >= *bend; });
    const auto middle = static_cast<std::size_t>(at - surfel);
    add_run(line, first_surfel, middle, {room.begin, *bend});
    add_run(line, middle, end_of_surfels, {*bend, room.end});
    return;
  }
  double area_m2 = 0.0;
  for (auto s = first; s != end; ++s) area_m2 += s->area_m2;
  runs_.push_back({beams, room, area_m2});
}

/// Adds the ribbon that the run belongs to, if it is one.
void RibbonExtraction::add_ribbon(const ThreeLines& lines, const Run& run) {
  const std::optional<FittedBeams> fitted = fit(lines, run.beams);
  if (!fitted) return;
  const BeamRange beams = grow(lines.middle, fitted->beams, run.room, fitted->plane);
  if (!is_large_enough(lines.middle, beams, fitted->plane)) return;
  result_.ribbons.push_back(describe(lines, beams, *fitted));
  std::fill(is_taken_.begin() + static_cast<std::ptrdiff_t>(beams.begin),
            is_taken_.begin() + static_cast<std::ptrdiff_t>(beams.end), 1);
}

/// Returns the beams to estimate the run's plane from: a short run is widened by the neighbourhood
/// of its middle. Empty if there is no such neighbourhood.
BeamRange RibbonExtraction::widened(const ThreeLines& lines, const BeamRange& run) const {
  if (run.size() >= 2 * static_cast<std::size_t>(config_.min_points)) return run;
  const BeamRange around = neighbourhood_of(lines, run.middle(), config_.neighbourhood_m);
  if (around.empty()) return {};
  return {std::min(run.begin, around.begin), std::max(run.end, around.end)};
}

/// Fits a plane to the run's returns on all three lines. Returns nothing if these are thicker than
/// noise explains or straddle an edge.
std::optional<RibbonExtraction::FittedBeams> RibbonExtraction::fit(const ThreeLines& lines,
                                                                   const BeamRange& run) const {
  const BeamRange beams = widened(lines, run);
  if (beams.empty()) return std::nullopt;
  const Moments moments = lines.moments(beams.begin, beams.end);
  const FittedBeams fitted{beams, moments, fit_plane(moments)};
  const double noise = config_.outlier_sigmas * scan_.range_sigma_m;
  if (fitted.plane.variances[0] > noise * noise) return std::nullopt;
  if (straddles_an_edge(lines, fitted)) return std::nullopt;
  return fitted;
}

/// Returns true if the middle line lies off the plane of all three lines. Where these straddle an
/// edge, the plane blends both faces; on a plane, the middle line's mean differs by noise alone.
bool RibbonExtraction::straddles_an_edge(const ThreeLines& lines, const FittedBeams& fitted) const {
  const PlaneFit& plane = fitted.plane;
  const Moments middle = lines.middle.moments(fitted.beams.begin, fitted.beams.end);
  const double offset = std::abs(plane.normal().dot(middle.mean() - plane.mean));
  const double standard_error =
      std::sqrt(plane.variances[0] * kMiddleLineVarianceFactor / middle.weight());
  return offset > config_.edge_sigmas * standard_error + config_.edge_slack_m;
}

/// Returns true if the errors of range and direction explain the beam's distance from the plane.
/// At grazing angles range noise hardly moves a point across the plane, so the base of the wall
/// behind can be distinguished from noise.
bool RibbonExtraction::lies_on(const PlaneFit& plane, const ScanLine& line,
                               std::size_t beam) const {
  const double distance = plane.normal().dot(line.points[beam] - plane.mean);
  const double square_sine = square(plane.normal().dot(line.directions[beam]));
  const double direction_sigma_m = scan_.direction_sigma_deg * kDegree * line.ranges_m[beam];
  const double variance =
      square_sine * square(scan_.range_sigma_m) + (1.0 - square_sine) * square(direction_sigma_m);
  return square(distance) <= square(config_.outlier_sigmas) * variance;
}

/// Extends the beams on both sides while the returns lie on the plane, then drops beams at the ends
/// that do not.
BeamRange RibbonExtraction::grow(const ScanLine& line, BeamRange beams, const BeamRange& room,
                                 const PlaneFit& plane) const {
  const auto fits = [&](std::size_t beam) {
    return !is_taken_[beam] && lies_on(plane, line, beam);
  };
  while (beams.begin > room.begin && fits(beams.begin - 1)) --beams.begin;
  while (beams.end < room.end && fits(beams.end)) ++beams.end;
  while (beams.begin < beams.end && !fits(beams.begin)) ++beams.begin;
  while (beams.end > beams.begin && !fits(beams.end - 1)) --beams.end;
  return beams;
}

/// Returns true if the beams have enough points, seen at an angle and over a length that suffice.
bool RibbonExtraction::is_large_enough(const ScanLine& line, const BeamRange& beams,
                                       const PlaneFit& plane) const {
  if (beams.size() < static_cast<std::size_t>(config_.min_points)) return false;
  const double grazing_sine = std::abs(plane.normal().dot(line.directions[beams.middle()]));
  if (grazing_sine < std::sin(config_.min_grazing_angle_deg * kDegree)) return false;
  const Eigen::Vector3d chord = line.points[beams.end - 1] - line.points[beams.begin];
  return chord.norm() >= config_.min_length_m;
}

/// Returns the ribbon of these beams, in the frame of its acquisition pose.
Ribbon RibbonExtraction::describe(const ThreeLines& lines, const BeamRange& beams,
                                  const FittedBeams& fitted) {
  const ScanLine& line = lines.middle;
  const PlaneFit& plane = fitted.plane;
  const Eigen::Vector3d chord = line.points[beams.end - 1] - line.points[beams.begin];
  const Eigen::Vector3d normal = side_of(line, beams.begin, plane) * plane.normal();
  const Eigen::Vector3d along = (chord - normal.dot(chord) * normal).normalized();
  const Eigen::Vector3d across = plane.normal().cross(chord).normalized();
  const double base_line_m = std::sqrt(across.dot(fitted.moments.covariance() * across));
  Moments moments = line.moments(beams.begin, beams.end);
  moments.spread(base_line_m * across);

  const Pose T_base_odom = line.T_odom_base.inverse(Eigen::Isometry);
  Ribbon ribbon;
  ribbon.first_beam = static_cast<std::uint32_t>(beams.begin);
  ribbon.last_beam = static_cast<std::uint32_t>(beams.end - 1);
  ribbon.moments = moments.transformed(T_base_odom);
  ribbon.normal = (T_base_odom.linear() * normal).cast<float>();
  ribbon.along = (T_base_odom.linear() * along).cast<float>();
  ribbon.sigma_across_rad =
      static_cast<float>(std::sqrt(plane.variances[0] / fitted.moments.weight()) / base_line_m);
  ribbon.area_m2 = static_cast<float>(capped_area_m2(lines, beams, config_.area_cap_m2));
  ribbon.samples = samples_of(line, beams, moments.mean(), normal, along);
  ribbon.length_m = ribbon.samples.length_m();
  return ribbon;
}

/// Appends the beams' samples to those of the line. The result points to the packer's memory, which
/// link_samples() replaces.
RibbonSamples RibbonExtraction::samples_of(const ScanLine& line, const BeamRange& beams,
                                           const Eigen::Vector3d& centroid,
                                           const Eigen::Vector3d& normal,
                                           const Eigen::Vector3d& along) {
  const double d_m = -normal.dot(centroid);
  for_each_stretch(line, beams.begin, beams.end, config_.sample_length_m,
                   [&](std::size_t begin, std::size_t end) {
                     const Moments moments = line.moments(begin, end);
                     const Eigen::Vector3d mean = moments.mean();
                     packer_.add(along.dot(mean - centroid), normal.dot(mean) + d_m,
                                 moments.mean_square_distance(normal, d_m), end - begin);
                   });
  const RibbonSamples samples = packer_.pack();
  samples_.insert(samples_.end(), samples.first, samples.first + samples.size);
  return samples;
}

/// Points the ribbons to their samples, now that these no longer move, and sorts them by beam.
void RibbonExtraction::link_samples() {
  const PackedSample* next = samples_.data();
  for (Ribbon& ribbon : result_.ribbons) {
    ribbon.samples.first = next;
    next += ribbon.samples.size;
  }
  std::sort(result_.ribbons.begin(), result_.ribbons.end(),
            [](const Ribbon& a, const Ribbon& b) { return a.first_beam < b.first_beam; });
}

void RibbonExtraction::find_left_over(const ScanLine& line) {
  left_over_.clear();
  const auto is_left_over = [&](std::size_t beam) {
    return line.has_return(beam) && !is_taken_[beam];
  };
  for (std::size_t begin = 0; begin < line.size(); ++begin) {
    if (!is_left_over(begin)) continue;
    std::size_t end = begin + 1;
    while (end < line.end_of_segment[begin] && is_left_over(end)) ++end;
    for_each_stretch(
        line, begin, end, config_.sample_length_m, [&](std::size_t first, std::size_t last) {
          left_over_.push_back({line.moments(first, last).mean() - sensor_origin_, last - first});
        });
    begin = end - 1;
  }
}

void RibbonExtraction::pack_left_over(const ScanLine& line) {
  const Pose T_base_odom = line.T_odom_base.inverse(Eigen::Isometry);
  UnassignedPoints& unassigned = result_.unassigned;
  unassigned = {};
  unassigned.sensor = (T_base_odom * sensor_origin_).cast<float>();
  double max_m = 0.0;  // an upper bound of each coordinate in any frame
  for (const LeftOver& point : left_over_) {
    max_m = std::max(max_m, point.from_sensor.cwiseAbs().sum());
  }
  unassigned.step_m =
      std::max(unassigned.step_m, static_cast<float>(max_m / UnassignedPoints::kMaxSteps));
  packed_points_.clear();
  for (const LeftOver& point : left_over_) {
    const Eigen::Vector3d steps = T_base_odom.linear() * point.from_sensor / unassigned.step_m;
    PackedPoint packed;
    for (int i = 0; i < 3; ++i) {
      packed.from_sensor[static_cast<std::size_t>(i)] =
          static_cast<std::int16_t>(std::lround(steps[i]));
    }
    packed.count =
        static_cast<std::uint16_t>(std::min<std::size_t>(point.count, UnassignedPoints::kMaxCount));
    packed_points_.push_back(packed);
  }
  unassigned.size = static_cast<std::uint32_t>(packed_points_.size());
  unassigned.first = packed_points_.data();
}

}  // namespace ribbon_mapper
