// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CGAL/Simple_cartesian.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <memory>
#include <utility>

#include "bench/normals/normals_peer.hpp"

namespace ribbon_mapper::bench {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using PointWithNormal = std::pair<Kernel::Point_3, Kernel::Vector_3>;

struct Sample {
  std::vector<PointWithNormal> points;
  std::vector<int> of_beam;  // index of each beam of the middle line, -1 for no return
};

Sample converted(const NormalsInput& lines) {
  Sample sample;
  sample.of_beam.assign(lines.middle().size(), -1);
  for (const ScanLine* line : {&lines.lines[0], &lines.lines[1], &lines.lines[2]}) {
    for (std::size_t i = 0; i < line->size(); ++i) {
      if (!line->has_return(i)) continue;
      if (line == &lines.middle()) sample.of_beam[i] = static_cast<int>(sample.points.size());
      const Eigen::Vector3d& p = line->points[i];
      sample.points.push_back({{p.x(), p.y(), p.z()}, {0.0, 0.0, 0.0}});
    }
  }
  return sample;
}

}  // namespace

std::vector<NormalsPeer> cgal_normals(const std::vector<NormalsInput>& lines) {
  auto samples = std::make_shared<std::vector<Sample>>();
  NormalsPeer peer;
  peer.name = "CGAL::pca_estimate_normals k 30, every point";
  for (const NormalsInput& sample : lines) {
    samples->push_back(converted(sample));
    peer.normals += samples->back().points.size();
  }
  peer.run = [samples] {
    for (Sample& sample : *samples) {
      CGAL::pca_estimate_normals<CGAL::Sequential_tag>(
          sample.points, 30,
          CGAL::parameters::point_map(CGAL::First_of_pair_property_map<PointWithNormal>())
              .normal_map(CGAL::Second_of_pair_property_map<PointWithNormal>()));
    }
  };
  peer.normal_at = [samples](std::size_t s, std::size_t beam) -> Eigen::Vector3d {
    const Sample& sample = (*samples)[s];
    if (sample.of_beam[beam] < 0) return no_normal();
    const Kernel::Vector_3& n = sample.points[sample.of_beam[beam]].second;
    return {n.x(), n.y(), n.z()};
  };
  return {peer};
}

}  // namespace ribbon_mapper::bench
