// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/normals/three_lines.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <map>

#include "bench/stopwatch.hpp"
#include "modeler/scan/line_buffer.hpp"

namespace ribbon_mapper::bench {
namespace {

NormalsInput snapshot(const ThreeLines& lines, const RecordedLine& recorded,
                      const ModelerConfig& config) {
  NormalsInput input;
  input.lines = {lines.previous, lines.middle, lines.next};
  input.recorded = &recorded;
  input.R_map_odom = recorded.T_map_odom_true.linear();
  for (std::size_t beam = 0; beam < lines.middle.size(); ++beam) {
    if (!lines.middle.has_return(beam)) continue;
    input.beams.push_back(beam);
    input.around.push_back(neighbourhood_of(lines, beam, config.ribbon.neighbourhood_m));
  }
  estimate_surfels(lines, config.scan, config.ribbon, input.surfels);
  return input;
}

}  // namespace

std::vector<NormalsInput> sample_lines(const Recording& recording, const ModelerConfig& config,
                                       std::size_t count) {
  std::vector<NormalsInput> samples;
  const double sigma_m = config.scan.range_sigma_m;
  LineBuffer buffer(config.scan.base_line_sigmas * sigma_m);
  std::map<Time, const RecordedLine*> by_stamp;
  const std::size_t stride = std::max<std::size_t>(1, recording.lines.size() / count);
  for (std::size_t i = 0; i < recording.lines.size(); ++i) {
    const RecordedLine& line = recording.lines[i];
    place_beams(line.beams, line.poses, config.scan, buffer.incoming());
    if (buffer.newest_line() && base_line_m(*buffer.newest_line(), buffer.incoming()) <
                                    config.scan.line_step_sigmas * sigma_m) {
      continue;
    }
    by_stamp[buffer.incoming().stamp] = &line;
    buffer.push();
    while (const auto lines = buffer.next_three_lines()) {
      if (samples.size() >= i / stride) continue;
      samples.push_back(snapshot(*lines, *by_stamp.at(lines->middle.stamp), config));
    }
  }
  return samples;
}

std::vector<Eigen::Matrix3d> covariances_of(const std::vector<NormalsInput>& samples) {
  std::vector<Eigen::Matrix3d> covariances;
  for (const NormalsInput& sample : samples) {
    for (const BeamRange& around : sample.around) {
      if (around.empty()) continue;
      covariances.push_back(sample.three_lines().moments(around.begin, around.end).covariance());
    }
  }
  return covariances;
}

double eigen_solve_ns(const std::vector<Eigen::Matrix3d>& covariances) {
  const double seconds = cpu_seconds_of([&] {
    for (const Eigen::Matrix3d& covariance : covariances) {
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
      solver.computeDirect(covariance);
      keep(solver);
    }
  });
  return 1e9 * seconds / static_cast<double>(covariances.size());
}

}  // namespace ribbon_mapper::bench
