// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/plane_landmarks.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "modeler/geometry/angles.hpp"
#include "test/modeler/association/scene.hpp"

namespace ribbon_mapper {
namespace {

using Eigen::Vector3d;
using RibbonsOfLine = std::vector<PlaneObservation>;

constexpr RangeNoise kNoise{0.01, 0.25};
const SharedSettings kShared{0.01, {2.0, 0.03}, 1.0};

/// Walls at given x, each of ribbons that are acquired from lines of their own at the origin.
class Walls {
 public:
  /// Adds a wall of 1 m length and `ribbons` ribbons 4 cm apart, that faces the origin. Its lines
  /// are localised by the segment, if one is given.
  void add(double x_m, int ribbons, std::optional<std::uint32_t> segment = {}) {
    for (int i = 0; i < ribbons; ++i) {
      Ribbon ribbon = ribbon_at(x_m, 0.5 + 0.04 * i);
      ribbon.pose = static_cast<std::uint32_t>(lines.size());
      ribbons_.push_back(ribbon);
      lines.push_back({});
      lines.back().localised_by = segment;
    }
  }

  static Ribbon ribbon_at(double x_m, double z_m, double y_m = 0.0) {
    return mini_world::ribbon_between({x_m, y_m - 0.5, z_m}, {x_m, y_m + 0.5, z_m},
                                      -Vector3d::UnitX());
  }

  PlaneLandmarks landmarks(const RegistrationConfig& config = {}) const {
    const std::vector<StampedPose> poses(lines.size());
    const PosedObservations observations(ribbons_, no_points_, poses);
    return {supported_planes(observations, lines, config, kShared),
            [&](std::uint32_t ribbon) { return observations.ribbon(ribbon); },
            kShared.bridged_gap_m, config};
  }

  std::vector<LineState> lines;

 private:
  std::vector<Ribbon> ribbons_;
  std::vector<UnassignedPoints> no_points_;
};

Walls one_wall(int ribbons = 12) {
  Walls walls;
  walls.add(2.0, ribbons);
  return walls;
}

/// The observation of a ribbon of the wall, with all landmarks as candidates.
PlaneObservation observed(const Ribbon& ribbon, const PlaneLandmarks& landmarks) {
  PlaneObservation observation(ribbon, kNoise, Vector6::Zero());
  for (std::uint32_t i = 0; i < landmarks.all().size(); ++i) observation.candidates.push_back(i);
  return observation;
}

PoseBelief belief_at(const Pose& pose, double sigma) {
  return {pose, sigma * sigma * Matrix6::Identity()};
}

/// The landmark that a ribbon at x = 2 m is matched to from a pose; -1 if none is.
int match(const PlaneLandmarks& landmarks, const PoseBelief& belief,
          const Ribbon& ribbon = Walls::ribbon_at(2.0, 0.7)) {
  const RibbonsOfLine observations{observed(ribbon, landmarks)};
  const auto matches = landmarks.matches(observations, belief);
  if (matches.empty()) return -1;
  EXPECT_EQ(&observations[0], matches[0].observation);
  return static_cast<int>(matches[0].landmark);
}

TEST(PlaneLandmarks, AreTheFacesWithAFrameOfTheirOwn) {
  Walls walls = one_wall();
  walls.add(3.0, 12);
  const PlaneLandmarks landmarks = walls.landmarks();
  ASSERT_EQ(2U, landmarks.all().size());
  for (int i = 0; i < 2; ++i) {
    const PlaneLandmark& wall = landmarks.all()[i];
    EXPECT_LT((wall.normal + Vector3d::UnitX()).norm(), 1e-4);
    EXPECT_NEAR(2.0 + i, wall.centroid.x(), 1e-4);
    EXPECT_NEAR(0.0, wall.axis_u.dot(wall.normal), 1e-9);
    EXPECT_LT((wall.normal.cross(wall.axis_u) - wall.axis_v).norm(), 1e-9);
  }
}

TEST(PlaneLandmarks, WithoutLinesOrRibbonsThereAreNone) {
  EXPECT_TRUE(Walls{}.landmarks().all().empty());
  Walls walls;
  walls.lines.resize(5);
  EXPECT_TRUE(walls.landmarks().all().empty());
}

TEST(PlaneLandmarks, NeedTheirNumberOfRibbons) {
  EXPECT_TRUE(one_wall(9).landmarks().all().empty());
  EXPECT_EQ(1U, one_wall(10).landmarks().all().size());
  RegistrationConfig config;
  config.min_ribbons = 9;
  EXPECT_EQ(1U, one_wall(9).landmarks(config).all().size());
}

TEST(PlaneLandmarks, RibbonsOfLinesThatAreNotLocalisedDoNotCount) {
  Walls walls = one_wall(12);
  for (int i = 0; i < 3; ++i) walls.lines[i].is_localised = false;
  EXPECT_TRUE(walls.landmarks().all().empty());
  walls.lines[0].is_localised = true;
  EXPECT_EQ(1U, walls.landmarks().all().size());
}

TEST(PlaneLandmarks, NeedSupportThatIsIndependentOfEachSegment) {
  Walls walls;
  walls.add(2.0, 15, 0U);
  EXPECT_TRUE(walls.landmarks().all().empty()) << "one segment may be wrong as a whole";
  walls.add(2.02, 4, 1U);
  walls.add(2.02, 5);
  EXPECT_TRUE(walls.landmarks().all().empty()) << "nine others";
  walls.add(2.02, 1, 2U);
  EXPECT_EQ(1U, walls.landmarks().all().size()) << "ten others";
}

TEST(PlaneLandmarks, AreFoundNearTheirRibbonsOnly) {
  const Walls walls = one_wall();
  PlaneLandmarks landmarks = walls.landmarks();
  const auto near = [&](const Ribbon& ribbon, const Pose& pose) {
    return landmarks.landmarks_near(PosedRibbon(ribbon, pose));
  };
  const std::vector<std::uint32_t> first{0}, none;
  const Ribbon on_it = Walls::ribbon_at(2.0, 0.7);
  EXPECT_EQ(first, near(on_it, Pose::Identity()));
  EXPECT_EQ(first, near(on_it, planar_pose(0.5, 0.0, 0.0))) << "drifted by half a metre";
  EXPECT_EQ(first, near(on_it, planar_pose(0.0, 0.0, 0.2))) << "whatever its direction";
  EXPECT_EQ(none, near(on_it, planar_pose(5.0, 0.0, 0.0)));
  EXPECT_EQ(none, near(on_it, planar_pose(0.0, -9.0, 0.0)));
}

TEST(Matches, RibbonsWhoseDistanceFitsTheBelief) {
  const PlaneLandmarks wall = one_wall().landmarks();
  EXPECT_EQ(0, match(wall, belief_at(Pose::Identity(), 0.0)));
  const Pose off = planar_pose(0.1, 0.0, 0.0);
  EXPECT_EQ(-1, match(wall, belief_at(off, 0.001)));
  EXPECT_EQ(0, match(wall, belief_at(off, 0.1)));
}

TEST(Matches, UpToTheLimitOfTheirSquaredSigmas) {
  const PlaneLandmarks wall = one_wall().landmarks();
  PoseBelief belief{planar_pose(0.34, 0.0, 0.0), Matrix6::Zero()};
  belief.covariance(0, 0) = square(0.1);  // 3.4 sigma: 11.6
  EXPECT_EQ(0, match(wall, belief));
  belief.T_model_base = planar_pose(0.35, 0.0, 0.0);  // 12.2
  EXPECT_EQ(-1, match(wall, belief));
  RegistrationConfig config;
  config.max_chi_square = 13.0;
  EXPECT_EQ(0, match(one_wall().landmarks(config), belief));
}

TEST(Matches, NoRibbonThatWasSeenFromTheOtherSide) {
  const PlaneLandmarks wall = one_wall().landmarks();
  const Ribbon behind =
      mini_world::ribbon_between({2.0, -0.5, 0.7}, {2.0, 0.5, 0.7}, Vector3d::UnitX());
  EXPECT_EQ(-1, match(wall, belief_at(Pose::Identity(), 0.01), behind));
}

/// A ribbon on the wall whose own normal is turned about its direction, which moves no point.
Ribbon tipped(double angle_deg) {
  const Eigen::AngleAxisd tip(angle_deg * kDegree, Vector3d::UnitY());
  return mini_world::ribbon_between({2.0, -0.5, 0.7}, {2.0, 0.5, 0.7}, -(tip * Vector3d::UnitX()));
}

TEST(Matches, NoRibbonThatIsTippedAcrossItsDirection) {
  const PlaneLandmarks wall = one_wall().landmarks();
  const PoseBelief exact = belief_at(Pose::Identity(), 1e-6);
  EXPECT_EQ(0, match(wall, exact, tipped(5.9)));
  EXPECT_EQ(-1, match(wall, exact, tipped(6.5)));
  EXPECT_EQ(-1, match(wall, exact, tipped(-6.5)));
  RegistrationConfig config;
  config.max_tilt_across_deg = 7.0;
  EXPECT_EQ(0, match(one_wall().landmarks(config), exact, tipped(6.5)));
}

TEST(Matches, ATiltAcrossWithinTheErrorsOfRibbonAndPose) {
  const PlaneLandmarks wall = one_wall().landmarks();
  EXPECT_EQ(0, match(wall, belief_at(Pose::Identity(), 0.5 * kDegree), tipped(6.9)));
  EXPECT_EQ(-1, match(wall, belief_at(Pose::Identity(), 0.5 * kDegree), tipped(7.6)));
  Ribbon weak = tipped(7.6);
  weak.sigma_across_rad = static_cast<float>(1.0 * kDegree);
  EXPECT_EQ(0, match(wall, belief_at(Pose::Identity(), 1e-6), weak));
}

Walls two_walls() {
  Walls walls = one_wall();
  walls.add(2.2, 12);
  return walls;
}

TEST(Matches, TheLikelierOfTwoPlanesIfItLeads) {
  const PlaneLandmarks walls = two_walls().landmarks();
  ASSERT_EQ(2U, walls.all().size());
  EXPECT_EQ(0, match(walls, belief_at(planar_pose(0.01, 0.0, 0.0), 0.05)));
  EXPECT_EQ(1, match(walls, belief_at(planar_pose(0.19, 0.0, 0.0), 0.05)));
}

TEST(Matches, NeitherOfTwoPlanesThatAreAboutAsLikely) {
  const PoseBelief between = belief_at(planar_pose(0.09, 0.0, 0.0), 0.1);
  EXPECT_EQ(-1, match(two_walls().landmarks(), between));
  RegistrationConfig config;
  config.min_chi_square_lead = 0.0;
  EXPECT_EQ(0, match(two_walls().landmarks(config), between));
}

TEST(Matches, OfTwoPlanesWithinTheNoiseTheLikelierOne) {
  const PlaneLandmarks walls = two_walls().landmarks();
  RibbonsOfLine observations{observed(Walls::ribbon_at(2.0, 0.7), walls)};
  observations[0].variances[0] = square(0.2);  // the planes are one sigma apart
  const auto matches = walls.matches(observations, belief_at(planar_pose(0.09, 0.0, 0.0), 0.001));
  ASSERT_EQ(1U, matches.size());
  EXPECT_EQ(0U, matches[0].landmark);
}

TEST(Measure, PutsThePoseWhereTheRibbonsFit) {
  const PlaneLandmarks wall = one_wall().landmarks();
  const PoseBelief drifted = belief_at(planar_pose(0.06, 0.03, 0.04), 0.05);
  const RibbonsOfLine observations{observed(Walls::ribbon_at(2.0, 0.6), wall),
                                   observed(Walls::ribbon_at(2.0, 0.8), wall)};
  const PoseBelief result = updated(drifted, wall.measure(observations, drifted));
  EXPECT_NEAR(0.0, result.T_model_base.translation().x(), 0.005);
  EXPECT_NEAR(0.0, yaw_of(result.T_model_base), 0.005);
  EXPECT_NEAR(0.03, result.T_model_base.translation().y(), 0.005) << "a wall does not say where";
  EXPECT_LT(result.covariance(5, 5), 0.1 * drifted.covariance(5, 5));
  EXPECT_NEAR(drifted.covariance(1, 1), result.covariance(1, 1), 0.1 * drifted.covariance(1, 1));
}

TEST(Measure, OneRibbonGivesTheTwoNumbersOfItsResidual) {
  const PlaneLandmarks wall = one_wall().landmarks();
  const PoseBelief here = belief_at(Pose::Identity(), 0.01);
  const RibbonsOfLine observations{observed(Walls::ribbon_at(2.0, 0.6), wall)};
  const PoseInformation measured = wall.measure(observations, here);
  EXPECT_EQ(2, Eigen::FullPivLU<Matrix6>(measured.matrix).setThreshold(1e-9).rank());
  const auto derivative =
      derivative_by_pose(observations[0], wall.all()[0].normal, measured.T_model_base);
  const Matrix6 expected =
      derivative.transpose() * observations[0].variances.cwiseInverse().asDiagonal() * derivative;
  EXPECT_LT((expected - measured.matrix).norm(), 1e-3 * expected.norm());
}

TEST(Measure, AResidualOfTwoSigmasHasHalfItsWeight) {
  const PlaneLandmarks wall = one_wall().landmarks();
  RibbonsOfLine observations{observed(Walls::ribbon_at(2.0, 0.6), wall)};
  const PoseBelief exact = belief_at(Pose::Identity(), 0.0);
  const Matrix6 full = wall.measure(observations, exact).matrix;
  const double sigma = std::sqrt(observations[0].variances[0]);
  const PoseBelief off = belief_at(planar_pose(2.0 * sigma, 0.0, 0.0), 0.0);
  EXPECT_NEAR(0.5, wall.measure(observations, off).matrix(0, 0) / full(0, 0), 0.01);
  RegistrationConfig config;
  config.robust_sigmas = 1e6;
  const Matrix6 plain = one_wall().landmarks(config).measure(observations, off).matrix;
  EXPECT_NEAR(1.0, plain(0, 0) / full(0, 0), 0.01);
}

TEST(Measure, WithoutAMatchItSaysNothing) {
  const PlaneLandmarks wall = one_wall().landmarks();
  const PoseBelief here = belief_at(planar_pose(0.2, 0.0, 0.0), 0.001);
  EXPECT_TRUE(wall.measure({}, here).matrix.isZero());
  const RibbonsOfLine far{observed(Walls::ribbon_at(2.0, 0.6), wall)};
  const PoseInformation measured = wall.measure(far, here);
  EXPECT_TRUE(measured.matrix.isZero());
  EXPECT_TRUE(measured.vector.isZero());
  EXPECT_LT((here.T_model_base.matrix() - measured.T_model_base.matrix()).norm(), 1e-12);
}

}  // namespace
}  // namespace ribbon_mapper
