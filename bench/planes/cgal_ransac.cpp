// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CGAL/Random.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>

#include "bench/planes/cgal_planes.hpp"

namespace ribbon_mapper::bench {
namespace {

using namespace cgal;
using Traits = CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, Cloud, PointMap, NormalMap>;
using Ransac = CGAL::Shape_detection::Efficient_RANSAC<Traits>;
using RansacPlane = CGAL::Shape_detection::Plane<Traits>;

struct Settings {
  unsigned int neighbours;
  std::size_t min_points;
  double gap_m;  ///< between points of one plane
};
Settings settings_of(Density density) {
  return density == Density::dense ? Settings{100, 1000, 0.2} : Settings{24, 150, 0.2};
}

std::vector<Points> detected(const Points& points, const Settings& settings) {
  Cloud cloud = with_normals(points, settings.neighbours);
  CGAL::get_default_random() = CGAL::Random(1);
  Ransac ransac;
  ransac.set_input(cloud);
  ransac.add_shape_factory<RansacPlane>();
  Ransac::Parameters parameters;
  parameters.probability = 0.01;
  parameters.min_points = settings.min_points;
  parameters.epsilon = 0.03;
  parameters.cluster_epsilon = settings.gap_m;
  parameters.normal_threshold = 0.9;
  ransac.detect(parameters);
  std::vector<Points> planes;
  for (const auto& shape : ransac.shapes()) {
    planes.push_back(points_of(cloud, shape->indices_of_assigned_points()));
  }
  return planes;
}

}  // namespace

PlanesPeer cgal_efficient_ransac(Density density) {
  const Settings settings = settings_of(density);
  return {"CGAL efficient RANSAC, normals of " + std::to_string(settings.neighbours),
          [settings](const Points& points) { return detected(points, settings); }};
}

}  // namespace ribbon_mapper::bench
