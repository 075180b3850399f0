// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/features/integral_image_normal.h>
#include <pcl/point_types.h>
#include <pcl/search/brute_force.h>

#include <limits>
#include <memory>

#include "bench/normals/normals_peer.hpp"

namespace ribbon_mapper::bench {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

struct Sample {
  Cloud::Ptr image = std::make_shared<Cloud>();  // three rows
  pcl::PointCloud<pcl::Normal> normals;
};

/// Converts lines to an image in an optical frame with z as depth, as PCL's class expects.
Sample converted(const NormalsInput& lines) {
  const ScanLine& middle = lines.middle();
  const Eigen::Vector3d origin = middle.origin(middle.size() / 2);
  const Eigen::Quaterniond to_optical = Eigen::Quaterniond::FromTwoVectors(
      middle.directions[middle.size() / 2], Eigen::Vector3d::UnitZ());
  Sample sample;
  for (const ScanLine* line : {&lines.lines[0], &middle, &lines.lines[2]}) {
    for (std::size_t i = 0; i < line->size(); ++i) {
      const Eigen::Vector3f p = (to_optical * (line->points[i] - origin)).cast<float>();
      const float none = std::numeric_limits<float>::quiet_NaN();
      sample.image->push_back(line->has_return(i) ? pcl::PointXYZ(p.x(), p.y(), p.z())
                                                  : pcl::PointXYZ(none, none, none));
    }
  }
  sample.image->width = static_cast<std::uint32_t>(middle.size());
  sample.image->height = 3;
  sample.image->is_dense = false;
  return sample;
}

}  // namespace

std::vector<NormalsPeer> pcl_integral_image_normals(const std::vector<NormalsInput>& lines) {
  auto samples = std::make_shared<std::vector<Sample>>();
  NormalsPeer peer;
  peer.name = "pcl::IntegralImageNormalEstimation, 3 x N";
  for (const NormalsInput& sample : lines) {
    samples->push_back(converted(sample));
    peer.normals += samples->back().image->size();
  }
  peer.run = [samples] {
    for (Sample& sample : *samples) {
      pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
      estimation.setNormalEstimationMethod(estimation.COVARIANCE_MATRIX);
      estimation.setBorderPolicy(estimation.BORDER_POLICY_MIRROR);
      estimation.setMaxDepthChangeFactor(0.05F);
      estimation.setDepthDependentSmoothing(false);
      estimation.setNormalSmoothingSize(3.0F);  // a larger window exceeds the three rows
      // No search takes place, but the default one would fit a camera to the image first.
      estimation.setSearchMethod(std::make_shared<pcl::search::BruteForce<pcl::PointXYZ>>());
      estimation.setInputCloud(sample.image);
      estimation.compute(sample.normals);
    }
  };
  peer.normal_at = [samples, &lines](std::size_t s, std::size_t beam) -> Eigen::Vector3d {
    const ScanLine& middle = lines[s].middle();
    const Eigen::Quaterniond to_optical = Eigen::Quaterniond::FromTwoVectors(
        middle.directions[middle.size() / 2], Eigen::Vector3d::UnitZ());
    const auto& normal = (*samples)[s].normals[middle.size() + beam];
    return to_optical.inverse() * normal.getNormalVector3fMap().cast<double>();
  };
  return {peer};
}

}  // namespace ribbon_mapper::bench
