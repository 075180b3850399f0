// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CGAL/Shape_detection/Region_growing/Region_growing.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing_on_point_set.h>

#include <iterator>

#include "bench/planes/cgal_planes.hpp"

namespace ribbon_mapper::bench {
namespace {

using namespace cgal;
namespace detection = CGAL::Shape_detection;
using Query = detection::Point_set::K_neighbor_query<Kernel, Cloud, PointMap>;
using Region =
    detection::Point_set::Least_squares_plane_fit_region<Kernel, Cloud, PointMap, NormalMap>;
using Sorting =
    detection::Point_set::Least_squares_plane_fit_sorting<Kernel, Cloud, Query, PointMap>;
using Growing = detection::Region_growing<Cloud, Query, Region, Sorting::Seed_map>;

struct Settings {
  unsigned int neighbours;
  double distance_m, angle_deg;
  std::size_t min_points;
};
Settings settings_of(Density density) {
  return density == Density::dense ? Settings{100, 0.05, 15.0, 500} : Settings{24, 0.05, 15.0, 150};
}

std::vector<Points> grown(const Points& points, const Settings& settings) {
  const Cloud cloud = with_normals(points, settings.neighbours);
  Query query(cloud, 12, PointMap());
  Region region(cloud, settings.distance_m, settings.angle_deg, settings.min_points, PointMap(),
                NormalMap());
  Sorting sorting(cloud, query, PointMap());
  sorting.sort();
  Growing growing(cloud, query, region, sorting.seed_map());
  std::vector<std::vector<std::size_t>> regions;
  growing.detect(std::back_inserter(regions));
  std::vector<Points> planes;
  for (const auto& indices : regions) planes.push_back(points_of(cloud, indices));
  return planes;
}

}  // namespace

PlanesPeer cgal_region_growing(Density density) {
  const Settings settings = settings_of(density);
  return {"CGAL region growing, normals of " + std::to_string(settings.neighbours),
          [settings](const Points& points) { return grown(points, settings); }};
}

}  // namespace ribbon_mapper::bench
