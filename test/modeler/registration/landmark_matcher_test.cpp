// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "modeler/geometry/angles.hpp"
#include "test/modeler/registration/walls.hpp"

namespace ribbon_mapper {
namespace {

using Eigen::Vector3d;
using RibbonsOfLine = std::vector<PlaneObservation>;

constexpr RangeNoise kNoise{0.01, 0.25};

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
  EXPECT_EQ(0, match(wall, exact, tipped(2.9)));
  EXPECT_EQ(-1, match(wall, exact, tipped(3.5)));
  EXPECT_EQ(-1, match(wall, exact, tipped(-3.5)));
  RegistrationConfig config;
  config.max_tilt_across_deg = 4.0;
  EXPECT_EQ(0, match(one_wall().landmarks(config), exact, tipped(3.5)));
}

TEST(Matches, ATiltAcrossWithinTheErrorsOfRibbonAndPose) {
  const PlaneLandmarks wall = one_wall().landmarks();
  EXPECT_EQ(0, match(wall, belief_at(Pose::Identity(), 0.5 * kDegree), tipped(4.8)));
  EXPECT_EQ(-1, match(wall, belief_at(Pose::Identity(), 0.5 * kDegree), tipped(5.1)));
  Ribbon weak = tipped(5.1);
  weak.sigma_across_rad = static_cast<float>(1.0 * kDegree);
  EXPECT_EQ(0, match(wall, belief_at(Pose::Identity(), 1e-6), weak));
}

TEST(Matches, OfTwoPlanesThatCrossInTheRibbonTheOneThatIsTippedLess) {
  const Eigen::Vector3d middle(2.0, 0.0, 0.7);
  std::vector<PlaneLandmark> landmarks;
  for (const double tip_deg : {11.0, 0.0}) {
    const Eigen::AngleAxisd tip(tip_deg * kDegree, Vector3d::UnitY());
    landmarks.push_back(
        {-(tip * Vector3d::UnitX()), Vector3d::UnitY(), -(tip * Vector3d::UnitZ()), middle});
  }
  Ribbon ribbon = tipped(4.0);
  ribbon.sigma_across_rad = static_cast<float>(4.0 * kDegree);  // both may be
  RibbonsOfLine line{PlaneObservation(ribbon, kNoise, Vector6::Zero())};
  line.front().candidates = {0, 1};
  const LandmarkMatcher matcher(landmarks, RegistrationConfig());
  const auto matches = matcher.matches(line, belief_at(Pose::Identity(), 0.01));
  ASSERT_EQ(1U, matches.size());
  EXPECT_EQ(1U, matches.front().landmark);
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

/// Whether a ribbon at the origin lies at one of the landmarks.
bool lies_at(const PlaneLandmarks& landmarks, const Ribbon& ribbon) {
  return landmarks.lies_at_candidate(observed(ribbon, landmarks),
                                     belief_at(Pose::Identity(), 0.01));
}

TEST(LiesAtCandidate, WithinTheGateOfTheDistance) {
  const PlaneLandmarks wall = one_wall().landmarks();
  EXPECT_TRUE(lies_at(wall, Walls::ribbon_at(2.03, 0.7)));
  EXPECT_FALSE(lies_at(wall, Walls::ribbon_at(2.1, 0.7)));
}

TEST(LiesAtCandidate, EvenIfItIsTiltedSoThatItMatchesNone) {
  const PlaneLandmarks wall = one_wall().landmarks();
  EXPECT_EQ(-1, match(wall, belief_at(Pose::Identity(), 0.01), tipped(30.0)));
  EXPECT_TRUE(lies_at(wall, tipped(30.0)));
}

TEST(LiesAtCandidate, OnItsSideAlone) {
  const PlaneLandmarks wall = one_wall().landmarks();
  EXPECT_FALSE(lies_at(
      wall, mini_world::ribbon_between({2.0, -0.5, 0.7}, {2.0, 0.5, 0.7}, Vector3d::UnitX())));
  EXPECT_FALSE(lies_at(
      wall, mini_world::ribbon_between({2.0, 0.0, 0.5}, {2.0, 0.0, 0.9}, Vector3d::UnitY())));
}

TEST(LiesAtCandidate, EvenIfItIsAmbiguous) {
  const PlaneLandmarks walls = two_walls().landmarks();
  const PoseBelief between = belief_at(planar_pose(0.09, 0.0, 0.0), 0.1);
  const PlaneObservation ribbon = observed(Walls::ribbon_at(2.0, 0.7), walls);
  EXPECT_TRUE(walls.matches({ribbon}, between).empty());
  EXPECT_TRUE(walls.lies_at_candidate(ribbon, between));
}

TEST(LiesAtCandidate, WithoutCandidatesItLiesAtNone) {
  const PlaneLandmarks wall = one_wall().landmarks();
  const PlaneObservation ribbon(Walls::ribbon_at(2.0, 0.7), kNoise, Vector6::Zero());
  EXPECT_FALSE(wall.lies_at_candidate(ribbon, belief_at(Pose::Identity(), 0.01)));
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
