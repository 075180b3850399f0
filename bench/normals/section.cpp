// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <optional>

#include "bench/micro.hpp"
#include "bench/normals/normals_peer.hpp"
#include "bench/sections.hpp"
#include "bench/stopwatch.hpp"
#include "modeler/geometry/angles.hpp"

namespace ribbon_mapper::bench {
namespace {

/// Function that returns the reference normal in map at one of our surfels, if there is one.
using Reference =
    std::function<std::optional<Eigen::Vector3d>(const NormalsInput& lines, const Surfel& surfel)>;

/// Returns the truth on planar faces as reference, or our normals if there is no truth. In the
/// latter case errors are merely differences from our normals.
Reference reference_of(const Recording& recording) {
  if (recording.face_normals.empty()) {
    return [](const NormalsInput& lines, const Surfel& surfel) -> std::optional<Eigen::Vector3d> {
      return lines.R_map_odom * surfel.normal;
    };
  }
  return [&recording](const NormalsInput& lines,
                      const Surfel& surfel) -> std::optional<Eigen::Vector3d> {
    const int face = lines.recorded->faces[surfel.beam];
    if (face < 0 || recording.face_normals[face].isZero()) return std::nullopt;
    return recording.face_normals[face];
  };
}

/// Angle errors of one peer [deg], also by range and by incidence.
struct AngleErrors {
  std::vector<double> all;
  std::array<std::vector<double>, 4> by_range;      // up to 2, 5, 10 m and beyond
  std::array<std::vector<double>, 3> by_incidence;  // up to 30, 60 and 90 deg
  std::size_t missing = 0;  ///< number of our normals that the peer does not have
};

std::size_t bin_of(double value, std::initializer_list<double> ends) {
  return static_cast<std::size_t>(
      std::count_if(ends.begin(), ends.end(), [value](double end) { return value > end; }));
}

/// Returns the errors at beams where we have a normal and there is a reference.
AngleErrors errors_of(const NormalsPeer& peer, const std::vector<NormalsInput>& samples,
                      const Reference& reference) {
  AngleErrors errors;
  if (!peer.normal_at) return errors;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const ScanLine& line = samples[s].middle();
    for (const Surfel& surfel : samples[s].surfels) {
      const auto truth = reference(samples[s], surfel);
      if (!truth) continue;
      const Eigen::Vector3d normal = samples[s].R_map_odom * peer.normal_at(s, surfel.beam);
      if (!normal.allFinite()) {
        ++errors.missing;
        continue;
      }
      const double error = to_degrees(std::acos(std::min(1.0, std::abs(normal.dot(*truth)))));
      const Eigen::Vector3d beam = samples[s].R_map_odom * line.directions[surfel.beam];
      const double incidence = to_degrees(std::acos(std::min(1.0, std::abs(beam.dot(*truth)))));
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

template <std::size_t size>
std::string medians_of(const std::array<std::vector<double>, size>& bins) {
  std::string text;
  for (const std::vector<double>& bin : bins) {
    char number[16] = " -";
    if (!bin.empty()) std::snprintf(number, sizeof number, " %.2f", median(bin));
    text += number;
  }
  return text;
}

std::string text_of(const AngleErrors& errors, const char* what) {
  char text[192];
  std::snprintf(text, sizeof text,
                "%s %.2f deg; up to 2, 5, 10 m, beyond:%s; incidence up to 30, 60, 90:%s", what,
                median(errors.all), medians_of(errors.by_range).c_str(),
                medians_of(errors.by_incidence).c_str());
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

std::vector<NormalsPeer> all_peers(const std::vector<NormalsInput>& samples,
                                   const ModelerConfig& config) {
  std::vector<NormalsPeer> peers = our_normals(samples, config);
  append(peers, pcl_normals(samples, config.ribbon.neighbourhood_m));
  append(peers, pcl_integral_image_normals(samples));
  append(peers, cgal_normals(samples));
  return peers;
}

const std::string kSection = "normals of the middle line, per normal";
const std::string kSolve = "Eigen computeDirect, one 3x3 solve";
constexpr std::size_t kOurs = 0, kPcl = 1;  // in all_peers(); kPcl has our neighbourhood

using Times = std::map<std::string, double>;  // ns per normal

Times times_of(const std::vector<NormalsPeer>& peers,
               const std::vector<Eigen::Matrix3d>& covariances) {
  MicroBenchmarks benchmarks;
  benchmarks.add(kSolve, covariances.size(), [&] { eigen_solve_ns(covariances); });
  for (const NormalsPeer& peer : peers) benchmarks.add(peer.name, peer.normals, peer.run);
  return benchmarks.ns_per_item();
}

/// Returns the row of a peer with its errors, if it has any; `what` names the errors.
Row row_of(const NormalsPeer& peer, const AngleErrors& errors, const char* what, double ns,
           double ours_ns) {
  Row row;
  row.section = kSection;
  row.name = peer.name;
  row.ns_per_item = ns;
  row.over_ours = ns / ours_ns;
  if (!errors.all.empty()) {
    row.accuracy = text_of(errors, what);
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
  const Recording& recording = inputs.recording;
  const Reference reference = reference_of(recording);
  const bool has_truth = !recording.face_normals.empty();
  // Few samples for the times, which then stay in the cache as lines do; many for the errors.
  const auto few = sample_lines(recording, inputs.config, 16);
  const auto many = sample_lines(recording, inputs.config, inputs.options.quick ? 100 : 400);
  const auto timed = all_peers(few, inputs.config), judged = all_peers(many, inputs.config);
  const Times ns = times_of(timed, covariances_of(few));
  const double ours_ns = ns.at(timed[kOurs].name), pcl_ns = ns.at(timed[kPcl].name);
  std::vector<double> medians_deg;
  for (const NormalsPeer& peer : judged) {
    peer.run();
    const bool is_reference = !has_truth && &peer == &judged[kOurs];
    const AngleErrors errors = is_reference ? AngleErrors() : errors_of(peer, many, reference);
    report.add(
        row_of(peer, errors, has_truth ? "median" : "median from ours", ns.at(peer.name), ours_ns));
    medians_deg.push_back(median_or_none(errors.all));
  }
  if (has_truth) report.set("normals_error_deg", medians_deg[kOurs]);
  report.set(has_truth ? "normals_pcl_error_deg" : "normals_pcl_from_ours_deg", medians_deg[kPcl]);
  std::size_t points = 0;
  for (const NormalsInput& sample : few) points += sample.beams.size();
  const double share = static_cast<double>(timed[kOurs].normals) / static_cast<double>(points);
  add_times(kSolve, ns.at(kSolve), report);
  add_times("ours, per point of the line", ours_ns * share, report);
  report.set("normals_vs_pcl", pcl_ns / ours_ns);
  report.set("normals_vs_pcl_per_point", pcl_ns / (ours_ns * share));
  report.set("normals_per_eigen", ours_ns * share / ns.at(kSolve));
  report.set("normals_per_eigen_per_normal", ours_ns / ns.at(kSolve));
}

}  // namespace ribbon_mapper::bench
