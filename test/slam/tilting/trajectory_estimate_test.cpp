// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/tilting/trajectory_estimate.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <map>

#include "modeler/geometry/angles.hpp"
#include "test/modeler/mini_world.hpp"

namespace ribbon_mapper::slam {
namespace {

using mini_world::Lines;
using mini_world::Motion;

/// Returns the same function of time after three seconds at its start: a sweep of the laser, from
/// which the estimate learns where the walls are.
mini_world::PoseByTime after_rest(const mini_world::PoseByTime& pose) {
  return [pose](double time_s) { return pose(std::max(0.0, time_s - 3.0)); };
}

const Motion kCircle{after_rest(mini_world::around_the_middle), mini_world::to_and_fro,
                     after_rest(mini_world::wandering_drift)};

Lines lines_of_circle(double from_s, double to_s) {
  return mini_world::drive(mini_world::room(), kCircle, from_s, to_s);
}

/// A model of lines, and an estimate that takes each of them.
struct Estimated {
  explicit Estimated(const Lines& lines, const ModelerConfig& config = {})
      : modeler(config), estimate(modeler.observations(), estimate_settings(config)) {
    for (const mini_world::Line& line : lines) {
      modeler.add_scan_line(line.beams, line.poses);
      revisions += estimate.update() ? 1 : 0;
    }
  }
  Modeler modeler;
  TrajectoryEstimate estimate;
  int revisions = 0;
};

/// The largest errors of a trajectory that begins at the true pose.
struct Errors {
  double distance_m = 0.0;
  double angle_deg = 0.0;
};

Errors errors_of(const std::vector<StampedPose>& trajectory, const Lines& lines) {
  std::map<Time, Pose> truth;
  for (const StampedPose& pose : mini_world::true_trajectory(lines)) {
    truth[pose.stamp] = pose.T_map_base;
  }
  const StampedPose& first = trajectory.front();
  const Pose T_map_estimate = truth.at(first.stamp) * first.T_map_base.inverse(Eigen::Isometry);
  Errors errors;
  for (const StampedPose& pose : trajectory) {
    const Pose error =
        truth.at(pose.stamp).inverse(Eigen::Isometry) * T_map_estimate * pose.T_map_base;
    errors.distance_m = std::max(errors.distance_m, error.translation().norm());
    errors.angle_deg = std::max(errors.angle_deg, to_degrees(angle_of(error)));
  }
  return errors;
}

/// The mean squared error of x, y and heading in standard deviations, for each of them.
double planar_nees_of(const TrajectoryEstimate& estimate, const Lines& lines) {
  const auto trajectory = estimate.trajectory(), truth = mini_world::true_trajectory(lines);
  const std::vector<Matrix6> covariances = estimate.covariances();
  std::map<Time, Pose> T_map_base;
  for (const StampedPose& pose : truth) T_map_base[pose.stamp] = pose.T_map_base;
  const StampedPose& first = trajectory.front();
  const Pose T_odom_map = first.T_map_base * T_map_base.at(first.stamp).inverse(Eigen::Isometry);
  double sum = 0.0;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    const Vector6 error =
        error_between(trajectory[i].T_map_base, T_odom_map * T_map_base.at(trajectory[i].stamp));
    constexpr std::array<int, 3> kPlanar{0, 1, 5};
    Eigen::Vector3d e;
    Eigen::Matrix3d covariance;
    for (int row = 0; row < 3; ++row) {
      e[row] = error[kPlanar[row]];
      for (int column = 0; column < 3; ++column) {
        covariance(row, column) = covariances[i](kPlanar[row], kPlanar[column]);
      }
    }
    sum += e.dot(covariance.ldlt().solve(e)) / 3.0;
  }
  return sum / static_cast<double>(trajectory.size() - 1);
}

TEST(TrajectoryEstimate, FollowsTheTruthWhereOdometryDrifts) {
  const Lines lines = lines_of_circle(0.0, 18.0);
  Estimated run(lines);
  const Errors odometry = errors_of(run.modeler.trajectory(), lines);
  ASSERT_GT(odometry.distance_m, 0.25);
  ASSERT_GT(odometry.angle_deg, 3.5);
  run.estimate.finish();
  const Errors errors = errors_of(run.estimate.trajectory(), lines);
  EXPECT_LT(errors.distance_m, 0.1 * odometry.distance_m);
  EXPECT_LT(errors.angle_deg, 0.1 * odometry.angle_deg);
}

TEST(TrajectoryEstimate, TracksOnTheWayAndRevises) {
  const Lines lines = lines_of_circle(0.0, 10.0);
  const Estimated run(lines);
  EXPECT_EQ(run.revisions, 3);  // one each 3 s
  EXPECT_LT(errors_of(run.estimate.trajectory(), lines).distance_m, 0.03);
  EXPECT_LT(run.estimate.covariance().diagonal().maxCoeff(), 1e-3);
}

TEST(TrajectoryEstimate, StandsStillWithTheOdometry) {
  const Lines lines =
      mini_world::drive(mini_world::room(), mini_world::tilting_in_place(), 0.0, 8.0);
  Estimated run(lines);
  run.estimate.finish();
  const Errors errors = errors_of(run.estimate.trajectory(), lines);
  EXPECT_LT(errors.distance_m, 1e-3);
  EXPECT_LT(errors.angle_deg, 0.02);
}

TEST(TrajectoryEstimate, BeginsAtTheOdometrysPose) {
  Estimated run(lines_of_circle(5.0, 9.0));
  run.estimate.finish();
  const Pose first = run.modeler.observations().trajectory().recorded()[0].T_odom_base;
  EXPECT_TRUE(run.estimate.trajectory().front().T_map_base.isApprox(first, 1e-12));
}

TEST(TrajectoryEstimate, OfNoLineIsEmpty) {
  Estimated run({});
  run.estimate.finish();
  EXPECT_FALSE(run.estimate.update());
  EXPECT_TRUE(run.estimate.trajectory().empty());
  EXPECT_TRUE(run.estimate.covariances().empty());
}

TEST(TrajectoryEstimate, OfAFewLinesIsTheOdometry) {
  const Lines lines = lines_of_circle(4.0, 4.3);
  Estimated run(lines);
  run.estimate.finish();
  ASSERT_FALSE(run.estimate.trajectory().empty());
  EXPECT_LT(errors_of(run.estimate.trajectory(), lines).distance_m, 0.01);
}

TEST(TrajectoryEstimate, IsTheSameHoweverOftenItIsUpdated) {
  const Lines lines = lines_of_circle(0.0, 8.0);
  const Estimated each(lines);
  const Modeler model = mini_world::model_of(lines);
  TrajectoryEstimate once(model.observations(), estimate_settings({}));
  EXPECT_TRUE(once.update());
  const auto a = each.estimate.trajectory(), b = once.trajectory();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].T_map_base.matrix(), b[i].T_map_base.matrix()) << "line " << i;
  }
}

TEST(TrajectoryEstimate, GoesOnWhenTheModelIsThinned) {
  ModelerConfig config;
  config.observations.max_ribbons = 800;
  const Lines lines = lines_of_circle(0.0, 12.0);
  Estimated run(lines, config);
  ASSERT_GT(run.modeler.statistics().thinned, 0U);
  run.estimate.finish();
  const auto poses = run.estimate.trajectory(), kept = run.modeler.trajectory();
  ASSERT_EQ(poses.size(), kept.size());
  for (std::size_t i = 0; i < poses.size(); ++i) EXPECT_EQ(poses[i].stamp, kept[i].stamp);
  EXPECT_LT(errors_of(poses, lines).distance_m, 0.04);
}

/// The true motion, as if another sensor saw it.
class TrueMotion : public OdometrySource {
 public:
  explicit TrueMotion(const Lines& lines) {
    for (const StampedPose& pose : mini_world::true_trajectory(lines)) {
      T_map_base_[pose.stamp] = pose.T_map_base;
    }
  }
  Pose T_odom_base(Time stamp, const Pose&) const override { return T_map_base_.at(stamp); }
  Eigen::Matrix3d step_covariance(Time, Time, const Pose&) const override {
    return 1e-8 * Eigen::Matrix3d::Identity();
  }

 private:
  std::map<Time, Pose> T_map_base_;
};

TEST(TrajectoryEstimate, IsMoreExactWithABetterSourceOfTheOdometry) {
  const Lines lines = lines_of_circle(0.0, 12.0);
  Estimated recorded(lines);
  recorded.estimate.finish();
  const TrueMotion truth(lines);
  TrajectoryEstimate refined(recorded.modeler.observations(), estimate_settings({}), &truth);
  refined.update();
  refined.finish();
  EXPECT_LT(errors_of(refined.trajectory(), lines).distance_m,
            0.5 * errors_of(recorded.estimate.trajectory(), lines).distance_m);
}

TEST(TrajectoryEstimate, StatesCovariancesThatItsErrorsAgreeWith) {
  const Lines lines = lines_of_circle(0.0, 18.0);
  Estimated run(lines);
  run.estimate.finish();
  const std::vector<Matrix6> covariances = run.estimate.covariances();
  ASSERT_EQ(covariances.size(), run.estimate.trajectory().size());
  EXPECT_EQ(covariances.front(), Matrix6::Zero());  // it defines the frame
  for (std::size_t i = 1; i < covariances.size(); ++i) {
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix6>(covariances[i]).eigenvalues()[0], 0.0) << i;
  }
  const double nees = planar_nees_of(run.estimate, lines);
  EXPECT_GT(nees, 0.02);  // a standard deviation is at most seven times the error
  EXPECT_LT(nees, 2.0);
}

TEST(TrajectoryEstimate, CovariancesAreAlongTheAxesOfOdom) {
  const Lines lines = lines_of_circle(0.0, 6.0);
  const Pose T_other_odom = planar_pose(2.0, -1.0, M_PI / 2.0);
  Lines moved = lines;
  for (mini_world::Line& line : moved) {
    for (Pose* pose : {&line.poses.T_odom_base_first, &line.poses.T_odom_base_last}) {
      *pose = T_other_odom * *pose;
    }
  }
  const auto a = Estimated(lines).estimate.covariances();
  const auto b = Estimated(moved).estimate.covariances();
  ASSERT_EQ(a.size(), b.size());
  const Matrix6 expected = in_other_axes(a.back(), T_other_odom.linear());
  EXPECT_LT((b.back() - expected).norm(), 0.01 * expected.norm());
  EXPECT_GT((b.back() - a.back()).norm(), 0.05 * expected.norm());
}

}  // namespace
}  // namespace ribbon_mapper::slam
