// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "bench/normals/normals_peer.hpp"
#include "bench/stopwatch.hpp"

namespace ribbon_mapper::bench {
namespace {

/// Computes running sums over a line. The modeler does this while placing beams, once per line
/// although each line is used in three buffers; it is part of the normals' cost.
void sum_up(const ScanLine& line, std::vector<Moments>& before) {
  Moments sum;
  before.resize(line.size() + 1);
  for (std::size_t i = 0; i < line.size(); ++i) {
    before[i] = sum;
    if (line.has_return(i)) sum.add(line.points[i]);
  }
  before[line.size()] = sum;
}

}  // namespace

std::vector<NormalsPeer> our_normals(const std::vector<NormalsInput>& samples,
                                     const ModelerConfig& config) {
  NormalsPeer peer;
  peer.name = "ours: running sums and normals";
  for (const NormalsInput& sample : samples) peer.normals += sample.surfels.size();
  auto surfels = std::make_shared<std::vector<Surfel>>();
  auto sums = std::make_shared<std::vector<Moments>>();
  peer.run = [&samples, config, surfels, sums] {
    for (const NormalsInput& sample : samples) {
      sum_up(sample.middle(), *sums);
      keep(sums->data());
      estimate_surfels(sample.three_lines(), config.scan, config.ribbon, *surfels);
      keep(surfels->data());
    }
  };
  peer.normal_at = [&samples](std::size_t s, std::size_t beam) {
    for (const Surfel& surfel : samples[s].surfels) {
      if (surfel.beam == beam) return surfel.normal;
    }
    return no_normal();
  };
  return {peer};
}

}  // namespace ribbon_mapper::bench
