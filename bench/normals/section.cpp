// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

#include "bench/micro.hpp"
#include "bench/normals/normals_peer.hpp"
#include "bench/sections.hpp"
#include "bench/stopwatch.hpp"

namespace ribbon_mapper::bench {
namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979323846;

/// Angle errors of one peer, by range and by incidence [deg].
struct AngleErrors {
  std::vector<double> all;
  std::array<std::vector<double>, 4> by_range;      // to 2, 5, 10 m and beyond
  std::array<std::vector<double>, 3> by_incidence;  // to 30, 60 and 90 deg
  std::size_t missing = 0;                          ///< where the peer gives none, though we do
};

std::size_t bin_of(double value, std::initializer_list<double> ends) {
  return static_cast<std::size_t>(
      std::count_if(ends.begin(), ends.end(), [value](double end) { return value > end; }));
}

/// At the beams where we have a normal, on flat faces.
AngleErrors errors_of(const NormalsPeer& peer, const std::vector<ThreeLines>& samples,
                      const Recording& tour) {
  AngleErrors errors;
  if (!peer.normal_at) return errors;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const ScanLine& line = samples[s].buffer.middle();
    for (const Surfel& surfel : samples[s].surfels) {
      const int face = samples[s].middle->faces[surfel.beam];
      if (face < 0 || tour.face_normals[face].isZero()) continue;
      const Eigen::Vector3d normal = samples[s].R_map_odom * peer.normal_at(s, surfel.beam);
      if (!normal.allFinite()) {
        ++errors.missing;
        continue;
      }
      const Eigen::Vector3d& truth = tour.face_normals[face];
      const double error = kDegrees * std::acos(std::min(1.0, std::abs(normal.dot(truth))));
      const Eigen::Vector3d beam = samples[s].R_map_odom * line.directions[surfel.beam];
      const double incidence = kDegrees * std::acos(std::min(1.0, std::abs(beam.dot(truth))));
      errors.all.push_back(error);
      errors.by_range[bin_of(line.ranges_m[surfel.beam], {2.0, 5.0, 10.0})].push_back(error);
      errors.by_incidence[bin_of(incidence, {30.0, 60.0})].push_back(error);
    }
  }
  return errors;
}

double median_or_none(const std::vector<double>& values) {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : median(values);
}

std::string text_of(const AngleErrors& errors) {
  char text[160];
  std::snprintf(text, sizeof text,
                "median %.2f deg; to 2, 5, 10 m, beyond: %.2f %.2f %.2f %.2f; "
                "incidence to 30, 60, 90: %.2f %.2f %.2f",
                median_or_none(errors.all), median_or_none(errors.by_range[0]),
                median_or_none(errors.by_range[1]), median_or_none(errors.by_range[2]),
                median_or_none(errors.by_range[3]), median_or_none(errors.by_incidence[0]),
                median_or_none(errors.by_incidence[1]), median_or_none(errors.by_incidence[2]));
  return text;
}

nlohmann::json json_of(const AngleErrors& errors) {
  nlohmann::json json;
  json["median_deg"] = median_or_none(errors.all);
  json["missing"] = errors.missing;
  json["count"] = errors.all.size();
  for (const auto& bin : errors.by_range) json["by_range_deg"].push_back(median_or_none(bin));
  for (const auto& bin : errors.by_incidence) {
    json["by_incidence_deg"].push_back(median_or_none(bin));
  }
  return json;
}

template <typename List>
void append(List& list, const List& more) {
  list.insert(list.end(), more.begin(), more.end());
}

std::vector<NormalsPeer> all_peers(const std::vector<ThreeLines>& samples,
                                   const ModelerConfig& config) {
  std::vector<NormalsPeer> peers = our_normals(samples, config);
  append(peers, pcl_normals(samples));
  append(peers, pcl_integral_image_normals(samples));
  append(peers, cgal_normals(samples));
  return peers;
}

const std::string kSection = "normals of the middle line, per normal";
const std::string kSolve = "Eigen computeDirect, one 3x3 solve";
const std::string kPcl = "pcl::NormalEstimation r 0.15 m";  // the same neighbourhood as ours

using Times = std::map<std::string, double>;  // ns per normal

Times times_of(const std::vector<NormalsPeer>& peers,
               const std::vector<Eigen::Matrix3d>& covariances) {
  MicroBenchmarks benchmarks;
  benchmarks.add(kSolve, covariances.size(), [&] { eigen_solve_ns(covariances); });
  for (const NormalsPeer& peer : peers) benchmarks.add(peer.name, peer.normals, peer.run);
  return benchmarks.ns_per_item();
}

/// A row of a peer, with its errors where it is asked what we are asked.
Row row_of(const NormalsPeer& peer, const AngleErrors& errors, double ns, double ours_ns) {
  Row row;
  row.section = kSection;
  row.name = peer.name;
  row.ns_per_item = ns;
  row.over_ours = ns / ours_ns;
  if (!errors.all.empty()) {
    row.accuracy = text_of(errors);
    row.details = json_of(errors);
  }
  return row;
}

void add_times(const std::string& name, double ns, Report& report) {
  Row row;
  row.section = kSection;
  row.name = name;
  row.ns_per_item = ns;
  report.add(row);
}

}  // namespace

void measure_normals(const Inputs& inputs, Report& report) {
  const Recording& tour = inputs.tour;
  // Few for the times, as lines come hot from the cache; many for the errors.
  const auto few = sample_buffers(tour, inputs.config, 16);
  const auto many = sample_buffers(tour, inputs.config, inputs.options.quick ? 100 : 400);
  const auto timed = all_peers(few, inputs.config), judged = all_peers(many, inputs.config);
  const Times ns = times_of(timed, covariances_of(few));
  const double ours_ns = ns.at(timed[0].name);
  for (const NormalsPeer& peer : judged) {
    peer.run();
    const AngleErrors errors = errors_of(peer, many, tour);
    report.add(row_of(peer, errors, ns.at(peer.name), ours_ns));
    if (&peer == &judged[0]) report.set("normals_error_deg", median(errors.all));
    if (peer.name == kPcl) report.set("normals_pcl_error_deg", median(errors.all));
  }
  std::size_t points = 0;
  for (const ThreeLines& sample : few) points += sample.beams.size();
  const double share = static_cast<double>(timed[0].normals) / static_cast<double>(points);
  add_times(kSolve, ns.at(kSolve), report);
  add_times("ours, per point of the line", ours_ns * share, report);
  report.set("normals_vs_pcl", ns.at(kPcl) / ours_ns);
  report.set("normals_vs_pcl_per_point", ns.at(kPcl) / (ours_ns * share));
  report.set("normals_per_eigen", ours_ns * share / ns.at(kSolve));
  report.set("normals_per_eigen_per_normal", ours_ns / ns.at(kSolve));
}

}  // namespace ribbon_mapper::bench
