// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/plane_adjustment.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "modeler/registration/odometry_noise.hpp"
#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {
namespace {

using Eigen::Vector3d;

const Vector6 no_motion = Vector6::Zero();

/// Floor, two walls; the robot drives along x and sees all of them, in ribbons that slant.
struct Hall {
  Hall() {
    for (int i = 1; i <= 20; ++i) {
      const Pose pose = planar_pose(0.05 * i, 0.0, 0.02 * i);
      const double x = 1.5 + 0.05 * i, z = 0.5 + 0.05 * i;
      truth.push_back(pose);
      see(pose, {x, 2.0, 0.0}, {x + 1.0, -1.0, 0.0}, 0);
      see(pose, {1.0, 3.0, z}, {3.0, 3.0, z + 0.5}, 1);
      see(pose, {4.0, -1.0, z}, {4.0, 2.0, z - 0.3}, 2);
    }
  }

  void see(const Pose& pose, const Vector3d& from, const Vector3d& to, int plane) {
    const Pose T_base_map = pose.inverse(Eigen::Isometry);
    sights.push_back({mini_world::ribbon_between(T_base_map * from, T_base_map * to,
                                                 T_base_map.linear() * planes[plane].normal),
                      0.01, no_motion});
  }

  /// All lines in one chain between poses that are known; every one `error` off.
  LineChain chain(const Vector6& error) const {
    const OdometryNoise noise;
    LineChain result;
    result.first_end = planar_pose(0.0, 0.0, 0.0);
    result.last_end = planar_pose(1.05, 0.0, 0.42);
    Pose before = *result.first_end;
    for (std::size_t i = 0; i <= truth.size(); ++i) {
      const Pose pose = i < truth.size() ? truth[i] : *result.last_end;
      result.steps.push_back(before.inverse(Eigen::Isometry) * pose);
      result.variances.push_back(noise.variances(result.steps.back()));
      before = pose;
      if (i == truth.size()) break;
      result.lines.push_back({moved(pose, error), {}});
      for (std::uint32_t k = 0; k < 3; ++k) {
        result.lines.back().sightings.push_back({&sights[3 * i + k], k});
      }
    }
    return result;
  }

  std::vector<SightedPlane> planes{
      {Vector3d::UnitZ(), Vector3d::UnitX(), Vector3d::UnitY(), {2.5, 0.5, 0.0}},
      {-Vector3d::UnitY(), Vector3d::UnitX(), -Vector3d::UnitZ(), {2.0, 3.0, 1.5}},
      {-Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ(), {4.0, 0.5, 1.0}}};
  std::vector<Pose> truth;
  std::vector<Sight> sights;
};

TEST(PlaneAdjustment, PlanesAndPosesThatErrTogetherComeBackTogether) {
  const Hall hall;
  Vector6 error;
  error << 0.02, -0.015, 0.01, 0.004, -0.003, 0.01;
  std::vector<LineChain> chains{hall.chain(error)};
  // The planes err as well, by about what these poses make of them.
  std::vector<SightedPlane> planes = hall.planes;
  for (SightedPlane& plane : planes) plane.centroid += 0.02 * plane.normal;
  for (int i = 0; i < 10; ++i) adjust({}, chains, planes);
  for (std::size_t i = 0; i < hall.truth.size(); ++i) {
    const Vector6 left = error_between(hall.truth[i], chains[0].lines[i].T_model_base);
    EXPECT_LT(left.norm(), 1e-4) << "line " << i;
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    EXPECT_LT((planes[i].normal - hall.planes[i].normal).norm(), 1e-4);
    EXPECT_NEAR(0.0, hall.planes[i].normal.dot(planes[i].centroid - hall.planes[i].centroid), 1e-4);
  }
}

TEST(PlaneAdjustment, FixedLinesHoldThePlanes) {
  const Hall hall;
  std::vector<LineChain> none;
  std::vector<FixedLine> fixed = hall.chain(Vector6::Zero()).lines;
  std::vector<SightedPlane> planes = hall.planes;
  planes[1] = moved(planes[1], Vector3d(0.02, -0.01, 0.05));
  for (int i = 0; i < 8; ++i) adjust(fixed, none, planes);
  EXPECT_LT((planes[1].normal - hall.planes[1].normal).norm(), 1e-4);
  EXPECT_NEAR(3.0, planes[1].centroid.y(), 1e-3);
}

TEST(Sight, DerivativesAreThoseOfTheResidual) {
  const Hall hall;
  const Pose pose = hall.truth[7];
  for (std::uint32_t k = 0; k < 3; ++k) {
    const Sight& sight = hall.sights[3 * 7 + k];
    const auto pose_derivative = by_pose(sight, hall.planes[k].normal, pose);
    const auto plane_derivative = by_plane(sight, hall.planes[k], pose);
    const Eigen::Vector2d here = residual_of(sight, hall.planes[k], pose);
    for (int i = 0; i < 6; ++i) {
      const Vector6 error = 1e-6 * Vector6::Unit(i);
      const Eigen::Vector2d there = residual_of(sight, hall.planes[k], moved(pose, error));
      EXPECT_LT(((there - here) / 1e-6 - pose_derivative.col(i)).norm(), 1e-4);
    }
    for (int i = 0; i < 3; ++i) {
      const SightedPlane plane = moved(hall.planes[k], 1e-6 * Vector3d::Unit(i));
      const Eigen::Vector2d there = residual_of(sight, plane, pose);
      EXPECT_LT(((there - here) / 1e-6 - plane_derivative.col(i)).norm(), 1e-4);
    }
  }
}

}  // namespace
}  // namespace ribbon_mapper
