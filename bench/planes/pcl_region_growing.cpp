// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/features/normal_3d.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>

#include <memory>

#include "bench/planes/planes_peer.hpp"

namespace ribbon_mapper::bench {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Tree = pcl::search::KdTree<pcl::PointXYZ>;

Cloud::Ptr to_pcl(const Points& points) {
  auto cloud = std::make_shared<Cloud>();
  cloud->reserve(points.size());
  for (const Eigen::Vector3f& p : points) cloud->push_back({p.x(), p.y(), p.z()});
  return cloud;
}

Points from_pcl(const Cloud& cloud) {
  Points points;
  points.reserve(cloud.size());
  for (const pcl::PointXYZ& p : cloud) points.push_back(p.getVector3fMap());
  return points;
}

/// Parameters by density. In raw clouds of a tilting laser, 30 neighbours lie within the noise, so
/// more are needed.
struct Settings {
  int neighbours;
  int min_points;
};
Settings settings_of(Density density) {
  return density == Density::dense ? Settings{100, 500} : Settings{30, 150};
}

std::vector<Points> grown(const Points& points, const Settings& settings) {
  const Cloud::Ptr cloud = to_pcl(points);
  const auto tree = std::make_shared<Tree>();
  const auto normals = std::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(tree);
  estimation.setKSearch(settings.neighbours);
  estimation.compute(*normals);
  pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
  growing.setInputCloud(cloud);
  growing.setInputNormals(normals);
  growing.setSearchMethod(tree);
  growing.setNumberOfNeighbours(30);
  growing.setMinClusterSize(settings.min_points);
  growing.setSmoothnessThreshold(5.0F / 180.0F * static_cast<float>(M_PI));
  growing.setCurvatureThreshold(0.05F);
  std::vector<pcl::PointIndices> clusters;
  growing.extract(clusters);
  std::vector<Points> planes;
  for (const pcl::PointIndices& cluster : clusters) {
    Points& plane = planes.emplace_back();
    for (const int index : cluster.indices) plane.push_back((*cloud)[index].getVector3fMap());
  }
  return planes;
}

}  // namespace

PlanesPeer pcl_region_growing(Density density) {
  const Settings settings = settings_of(density);
  return {"pcl::RegionGrowing, k " + std::to_string(settings.neighbours),
          [settings](const Points& points) { return grown(points, settings); }};
}

Points voxel_grid(const Points& points, float voxel_m) {
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(to_pcl(points));
  grid.setLeafSize(voxel_m, voxel_m, voxel_m);
  Cloud voxels;
  grid.filter(voxels);
  return from_pcl(voxels);
}

}  // namespace ribbon_mapper::bench
