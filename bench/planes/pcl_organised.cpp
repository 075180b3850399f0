// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/features/integral_image_normal.h>
#include <pcl/point_types.h>
#include <pcl/search/brute_force.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>

#include <memory>

#include "bench/planes/planes_peer.hpp"

namespace ribbon_mapper::bench {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr to_pcl(const Sweep& sweep) {
  auto cloud = std::make_shared<Cloud>();
  for (const Eigen::Vector3f& p : sweep.pixels) cloud->push_back({p.x(), p.y(), p.z()});
  cloud->width = static_cast<std::uint32_t>(sweep.width);
  cloud->height = static_cast<std::uint32_t>(sweep.pixels.size() / sweep.width);
  cloud->is_dense = false;
  return cloud;
}

pcl::PointCloud<pcl::Normal>::Ptr normals_of(const Cloud::Ptr& cloud) {
  auto normals = std::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod(estimation.COVARIANCE_MATRIX);
  estimation.setMaxDepthChangeFactor(0.05F);
  estimation.setNormalSmoothingSize(10.0F);
  estimation.setSearchMethod(std::make_shared<pcl::search::BruteForce<pcl::PointXYZ>>());
  estimation.setInputCloud(cloud);
  estimation.compute(*normals);
  return normals;
}

void segment(const Sweep& sweep, std::vector<Points>& planes) {
  const Cloud::Ptr cloud = to_pcl(sweep);
  pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label> segmentation;
  segmentation.setMinInliers(150);
  segmentation.setAngularThreshold(6.0 / 180.0 * M_PI);
  segmentation.setDistanceThreshold(0.05);  // times squared depth
  segmentation.setMaximumCurvature(0.05);
  segmentation.setInputCloud(cloud);
  segmentation.setInputNormals(normals_of(cloud));
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> inliers;
  segmentation.segment(models, inliers);
  const Eigen::Isometry3f T = sweep.T_map_image.cast<float>();
  for (const pcl::PointIndices& list : inliers) {
    Points& plane = planes.emplace_back();
    for (const int index : list.indices) plane.push_back(T * (*cloud)[index].getVector3fMap());
  }
}

}  // namespace

std::vector<Points> pcl_organised_planes(const std::vector<Sweep>& sweeps) {
  std::vector<Points> planes;
  for (const Sweep& sweep : sweeps) segment(sweep, planes);
  return planes;
}

}  // namespace ribbon_mapper::bench
