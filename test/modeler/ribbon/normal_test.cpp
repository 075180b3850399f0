// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The paper takes its normals from PCL, the core from summed moments. With the same neighbours both
// must agree. This is the only file that includes PCL's headers, which are slow to compile.
#include <gtest/gtest.h>
#include <pcl/features/normal_3d.h>
#include <pcl/point_types.h>

#include <cmath>
#include <limits>

#include "modeler/geometry/plane_fit.hpp"
#include "modeler/ribbon/surfel.hpp"
#include "test/modeler/ribbon/three_lines.hpp"

namespace ribbon_mapper {
namespace {

using namespace mini_world;

/// Returns the points of these beams of all lines relative to `origin`.
pcl::PointCloud<pcl::PointXYZ> neighbours(const LineTriple& lines, const BeamRange& around,
                                          const Eigen::Vector3d& origin) {
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (const ScanLine* line : {&lines.previous, &lines.middle, &lines.next}) {
    for (std::size_t i = around.begin; i < around.end; ++i) {
      const Eigen::Vector3f p = (line->points[i] - origin).cast<float>();
      cloud.push_back({p.x(), p.y(), p.z()});
    }
  }
  return cloud;
}

/// Returns the error of a normal that PCL's single precision may cause. It grows as the base line
/// across the lines shrinks relative to the length along them.
double rounding_rad(const PlaneFit& fit) {
  return 200.0 * std::numeric_limits<float>::epsilon() * fit.variances[2] /
         (fit.variances[1] - fit.variances[0]);
}

/// The agreement of normals with PCL's.
struct Comparison {
  int surfels = 0;             ///< normals compared
  int sharp = 0;               ///< of which PCL's rounding error is below 0.2 degrees
  double max_roundings = 0.0;  ///< largest angle between normals, in units of rounding_rad()
};

void compare_with_pcl(const LineTriple& lines, const RibbonConfig& config, Comparison& result) {
  std::vector<Surfel> surfels;
  estimate_surfels(lines, {}, config, surfels);
  for (const Surfel& surfel : surfels) {
    const auto around = neighbourhood_of(lines, surfel.beam, config.neighbourhood_m);
    const auto cloud = neighbours(lines, around, surfel.point);
    Eigen::Vector4f plane;
    float curvature;
    ASSERT_TRUE(pcl::computePointNormal(cloud, plane, curvature));
    const Eigen::Vector3d normal = plane.head<3>().cast<double>();
    Moments moments;
    for (const pcl::PointXYZ& p : cloud) moments.add({p.x, p.y, p.z});
    const double rounding = rounding_rad(fit_plane(moments));
    const double angle_rad = std::asin(std::min(1.0, normal.cross(surfel.normal).norm()));
    result.max_roundings = std::max(result.max_roundings, angle_rad / rounding);
    ++result.surfels;
    result.sharp += rounding < 3.5e-3;
  }
}

TEST(Normals, AgreeWithPclOnTheSameNeighbours) {
  const Motion motion{around_the_middle, to_and_fro, wandering_drift};
  for (const double sigma_m : {0.0, 0.005, 0.018}) {
    Comparison result;
    for (const double time_s : {0.3, 1.0, 2.2, 4.0, 6.5}) {
      compare_with_pcl(three_lines(room(), motion, time_s, {361, sigma_m, 7}), {}, result);
    }
    EXPECT_GT(result.surfels, 400);
    EXPECT_GT(result.sharp, 0.8 * result.surfels);
    EXPECT_LT(result.max_roundings, 1.0) << "sigma " << sigma_m;
  }
}

TEST(Normals, EqualThoseOfTheFaces) {
  const Motion motion{around_the_middle, to_and_fro, no_drift};
  const LineTriple lines = three_lines(room(), motion, 1.0, {361, 0.0, 1});
  std::vector<Surfel> surfels;
  estimate_surfels(lines, {}, {}, surfels);
  const World faces = room();
  std::size_t on_one_face = 0;
  for (const Surfel& surfel : surfels) {
    for (const Face& face : faces) {
      if (std::abs(face.normal.dot(surfel.point) + face.d_m) > 1e-3) continue;
      const auto around = neighbourhood_of(lines, surfel.beam, RibbonConfig{}.neighbourhood_m);
      Moments moments = lines.middle.moments(around.begin, around.end);
      moments += lines.previous.moments(around.begin, around.end);
      moments += lines.next.moments(around.begin, around.end);
      if (moments.mean_square_distance(face.normal, face.d_m) > 1e-8) continue;  // at an edge
      EXPECT_GT(surfel.normal.dot(face.normal), 1.0 - 1e-5);  // pointing to the sensor
      ++on_one_face;
    }
  }
  EXPECT_GT(on_one_face, surfels.size() / 2);
}

}  // namespace
}  // namespace ribbon_mapper
