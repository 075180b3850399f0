// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bench/normals/three_lines.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <map>

#include "bench/stopwatch.hpp"

namespace ribbon_mapper::bench {
namespace {

ThreeLines snapshot(const LineBuffer& buffer, const RecordedLine& middle,
                    const ModelerConfig& config) {
  ThreeLines sample;
  sample.buffer = buffer;
  sample.middle = &middle;
  sample.R_map_odom = middle.T_map_odom_true.linear();
  for (std::size_t beam = 0; beam < buffer.middle().size(); ++beam) {
    if (!buffer.middle().has_return(beam)) continue;
    sample.beams.push_back(beam);
    sample.around.push_back(neighbourhood_of(buffer, beam, config.ribbon.neighbourhood_m));
  }
  estimate_surfels(buffer, config.scan, config.ribbon, sample.surfels);
  return sample;
}

}  // namespace

std::vector<ThreeLines> sample_buffers(const Recording& recording, const ModelerConfig& config,
                                       std::size_t count) {
  std::vector<ThreeLines> samples;
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
    while (buffer.advance()) {
      if (samples.size() >= i / stride) continue;
      samples.push_back(snapshot(buffer, *by_stamp.at(buffer.middle().stamp), config));
    }
  }
  return samples;
}

std::vector<Eigen::Matrix3d> covariances_of(const std::vector<ThreeLines>& samples) {
  std::vector<Eigen::Matrix3d> covariances;
  for (const ThreeLines& sample : samples) {
    for (const Neighbourhood& around : sample.around) {
      if (around.size() == 0) continue;
      const Moments all = sample.buffer.previous().moments(around.begin, around.end) +
                          sample.buffer.middle().moments(around.begin, around.end) +
                          sample.buffer.next().moments(around.begin, around.end);
      covariances.push_back(all.covariance());
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
