// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "test/modeler/registration/hall.hpp"

#include <random>

#include "modeler/registration/odometry_noise.hpp"
#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper::hall {

using Eigen::Vector3d;

std::vector<PlaneLandmark> planes() {
  return {{Vector3d::UnitZ(), Vector3d::UnitX(), Vector3d::UnitY(), {2.5, 0.5, 0.0}},
          {-Vector3d::UnitY(), Vector3d::UnitX(), -Vector3d::UnitZ(), {2.0, 3.0, 1.5}},
          {-Vector3d::UnitX(), Vector3d::UnitY(), -Vector3d::UnitZ(), {4.0, 0.5, 1.0}}};
}

Pose true_pose(int line) { return planar_pose(0.05 * (line + 1), 0.0, 0.02 * (line + 1)); }

std::vector<Ribbon> ribbons_of_line(int line) {
  const double offset_m = 0.05 * (9 * line % 23 + 1);  // ribbons of successive lines lie apart
  const double x = 1.5 + offset_m, z = 0.5 + offset_m;
  const std::vector<std::pair<Vector3d, Vector3d>> ends{{{x, 2.0, 0.0}, {x + 1.0, -1.0, 0.0}},
                                                        {{1.0, 3.0, z}, {3.0, 3.0, z + 0.5}},
                                                        {{4.0, -1.0, z}, {4.0, 2.0, z - 0.3}}};
  const Pose T_base_map = true_pose(line).inverse(Eigen::Isometry);
  std::vector<Ribbon> ribbons;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    ribbons.push_back(mini_world::ribbon_between(T_base_map * ends[i].first,
                                                 T_base_map * ends[i].second,
                                                 T_base_map.linear() * planes()[i].normal));
  }
  return ribbons;
}

std::vector<PlaneObservation> observations_of_line(int line) {
  std::vector<PlaneObservation> observations;
  for (const Ribbon& ribbon : ribbons_of_line(line)) {
    observations.emplace_back(ribbon, RangeNoise{0.01, 0.25}, Vector6::Zero());
    observations.back().candidates = {static_cast<std::uint32_t>(observations.size() - 1)};
  }
  return observations;
}

TrajectorySegment segment(int lines) {
  TrajectorySegment result;
  result.end_line = static_cast<std::uint32_t>(lines);
  result.T_frame_start = true_pose(-1);
  result.T_frame_end = true_pose(lines);
  for (int i = 0; i <= lines; ++i) {
    result.steps.push_back(true_pose(i - 1).inverse(Eigen::Isometry) * true_pose(i));
  }
  set_step_variances(OdometryNoise{}, result);
  return result;
}

Eigen::MatrixXd random_matrix(int rows, int columns, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return uniform(random); });
}

Pose any_pose(unsigned seed) {
  const Vector6 numbers = random_matrix(6, 1, seed);
  return Eigen::Translation3d(3.0 * numbers.head<3>()) *
         Eigen::AngleAxisd(numbers.tail<3>().norm(), numbers.tail<3>().normalized());
}

Matrix6 any_covariance(double sigma, unsigned seed) {
  const Matrix6 root = random_matrix(6, 6, seed) + 2.0 * Matrix6::Identity();
  return sigma * sigma * root * root.transpose();
}

double difference(const Pose& a, const Pose& b) { return (a.matrix() - b.matrix()).norm(); }

}  // namespace ribbon_mapper::hall
