// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/lines/posed_lines.hpp"

#include <gtest/gtest.h>

#include <array>

#include "slam/lines/context.hpp"

namespace ribbon_mapper::slam {
namespace {

/// Adds a line with so many ribbons, one metre further along x.
void add_line(Observations& observations, int ribbons) {
  const auto line = static_cast<int>(observations.trajectory().size());
  Ribbon ribbon;
  Moments moments;
  for (const double y : {0.0, 0.5, 1.0}) moments.add({2.0, y, 0.0});
  ribbon.moments = moments;
  ribbon.length_m = 1.0F;
  LineObservations observed;
  observed.ribbons.assign(static_cast<std::size_t>(ribbons), ribbon);
  observations.add_line({{Time(1'000'000) * line, Pose::Identity()}, planar_pose(line, 0.0, 0.0)},
                        observed);
}

TEST(PosedLines, HaveTheRibbonsAndStepsOfTheirObservations) {
  Observations observations({});
  for (const int ribbons : {2, 0, 3}) add_line(observations, ribbons);
  PosedLines lines(observations);
  while (lines.has_next()) lines.add_next();
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines.first_ribbon(1), 2U);
  EXPECT_EQ(lines.first_ribbon(2), 2U);
  EXPECT_EQ(lines.first_ribbon(3), 5U);
  EXPECT_EQ(lines.measured(0, {}, {0.01, 0.25}).size(), 2U);
  EXPECT_TRUE(lines.measured(1, {}, {0.01, 0.25}).empty());
  EXPECT_TRUE(lines.step(0).isApprox(Pose::Identity()));
  EXPECT_TRUE(lines.step(2).isApprox(planar_pose(1.0, 0.0, 0.0)));
  EXPECT_DOUBLE_EQ(lines.seconds_between(0, 2), 0.002);
}

/// Line k is at k metres; of twenty in a row, one stands for all.
TEST(LinesNear, AreThoseWithinARadiusOfPlacesAndBeforeTheEnd) {
  Observations observations({});
  for (int i = 0; i < 100; ++i) add_line(observations, 1);
  PosedLines lines(observations);
  while (lines.has_next()) lines.add_next();
  for (std::uint32_t i = 0; i < 100; ++i) lines.set_pose(i, planar_pose(i, 0.0, 0.0));
  const EstimateConfig config;
  const auto near_10 = lines_near(places_of(lines, {10, 11}), 15.0, lines, 30, config);
  ASSERT_EQ(near_10.size(), 30U);
  EXPECT_EQ(near_10.front(), 0U);
  EXPECT_EQ(near_10.back(), 29U);
  const Pose move = planar_pose(70.0, 0.0, 0.0);
  const auto near_80 = lines_near(places_of(lines, {10, 11}, move), 5.0, lines, 100, config);
  ASSERT_EQ(near_80.size(), 20U);
  EXPECT_EQ(near_80.front(), 80U);
  EXPECT_TRUE(lines_near({}, 100.0, lines, 100, config).empty());
}

TEST(PosedLines, KeepTheirPosesWhenObservationsAreThinned) {
  Observations observations({});
  for (const int ribbons : {3, 3, 3, 3}) add_line(observations, ribbons);
  PosedLines lines(observations);
  EXPECT_FALSE(lines.keep_in_step());
  while (lines.has_next()) {
    lines.add_next();
    lines.set_pose(lines.size() - 1, planar_pose(0.0, lines.size(), 0.0));
  }
  observations.thin(4);
  EXPECT_TRUE(lines.keep_in_step());
  ASSERT_EQ(lines.size(), observations.trajectory().size());
  EXPECT_EQ(lines.first_ribbon(lines.size()), 4U);
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    const double number = 1.0 + static_cast<double>(lines.stamp(i).count()) / 1e6;
    EXPECT_DOUBLE_EQ(lines.T_start_base(i).translation().y(), number);
    EXPECT_EQ(lines.ribbon(lines.first_ribbon(i)).pose, i);
  }
  EXPECT_FALSE(lines.keep_in_step());
}

TEST(PosedLines, KeepTheStepThatHoldsASlipWhenObservationsAreThinned) {
  for (const std::uint32_t slip : {1U, 2U, 3U, 4U, 5U}) {
    Observations observations({});
    for (int line = 0; line < 6; ++line) add_line(observations, line % 2 == 0 ? 1 : 4);
    PosedLines lines(observations);
    while (lines.has_next()) lines.add_next();
    lines.set_slip(slip, true);
    lines.keep_in_step();
    observations.thin(5);
    ASSERT_TRUE(lines.keep_in_step());
    std::int64_t before = 0;  // number that the line before had
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
      const std::int64_t number = lines.stamp(i).count() / 1'000'000;
      EXPECT_EQ(lines.is_slip(i), before < slip && slip <= number) << slip << " at " << number;
      before = number;
    }
  }
}

TEST(PosedLines, ForgetASlipThatIsTakenBack) {
  Observations observations({});
  PosedLines lines(observations);
  lines.set_slip(7, true);
  EXPECT_TRUE(lines.is_slip(7));
  lines.set_slip(7, false);
  EXPECT_FALSE(lines.is_slip(7));
}

TEST(PosedLines, CountTheStepsOfASlip) {
  Observations observations({});
  PosedLines lines(observations);
  for (const std::uint32_t line : {3U, 6U, 7U, 8U}) lines.set_slip(line, true);
  EXPECT_EQ(lines.slip_length(2), 0U);
  EXPECT_EQ(lines.slip_length(3), 1U);
  for (const std::uint32_t line : {6U, 7U, 8U}) EXPECT_EQ(lines.slip_length(line), 3U);
}

/// Twice the way, which is known well across and not at all along, and a count of the questions.
class TwiceTheWay : public OdometrySource {
 public:
  Pose T_odom_base(Time, const Pose& recorded) const override {
    ++questions;
    return Pose(Eigen::Translation3d(2.0 * recorded.translation()));
  }
  Eigen::Matrix3d step_covariance(Time from, Time to, const Pose& step) const override {
    EXPECT_EQ(to - from, Time(1'000'000));
    EXPECT_TRUE(step.isApprox(planar_pose(2.0, 0.0, 0.0)));
    return kStep.asDiagonal();
  }
  mutable int questions = 0;
  inline static const Eigen::Vector3d kStep{1.0, 1e-4, 2e-4};
};

/// Lines that take the steps of a source.
struct LinesOfASource {
  LinesOfASource() {
    for (const int ribbons : {3, 3, 3, 3}) add_line(observations, ribbons);
    lines.keep_in_step();
    while (lines.has_next()) lines.add_next();
  }
  Observations observations{TrajectoryConfig{}};
  TwiceTheWay source;
  PosedLines lines{observations, &source};
};

TEST(PosedLines, TakeTheStepsOfASourceAndAskItOncePerLine) {
  LinesOfASource with;
  EXPECT_TRUE(with.lines.step(2).isApprox(planar_pose(2.0, 0.0, 0.0)));
  EXPECT_TRUE(with.lines.recorded_step(2).isApprox(planar_pose(1.0, 0.0, 0.0)));
  EXPECT_EQ(with.source.questions, 4);
  with.observations.thin(4);
  ASSERT_TRUE(with.lines.keep_in_step());
  for (std::uint32_t i = 0; i < with.lines.size(); ++i) {
    const double number = static_cast<double>(with.lines.stamp(i).count()) / 1e6;
    EXPECT_DOUBLE_EQ(with.lines.T_odom_base(i).translation().x(), 2.0 * number);
  }
  EXPECT_EQ(with.source.questions, 4);
}

/// Expects a covariance to be that of the recorded noise and of so many steps of the source.
void expect_fused(const PosedLines& lines, std::size_t line, double steps) {
  OdometryNoise noise;
  noise.planar_scale = 3.0;
  const Vector6 recorded = noise.variances(lines.step(line));
  const Matrix6 fused = lines.fused_covariance(line, noise);
  const std::array<int, 3> planar{0, 1, 5};
  for (std::size_t i = 0; i < planar.size(); ++i) {
    const int k = planar[i];
    const double source = steps * TwiceTheWay::kStep[static_cast<Eigen::Index>(i)];
    const double expected = 1.0 / (1.0 / recorded[k] + 1.0 / source);
    EXPECT_NEAR(fused(k, k), expected, 1e-5 * expected + 1e-9) << k;
  }
  for (const int k : {2, 3, 4}) EXPECT_EQ(fused(k, k), recorded[k]);
}

TEST(PosedLines, FuseTheNoiseOfTheOdometryWithThatOfTheSource) {
  LinesOfASource with;
  expect_fused(with.lines, 2, 1.0);
  const Matrix6 fused = with.lines.fused_covariance(2, {});
  const PoseBelief belief = with.lines.after_step_to(2, {}, {});
  EXPECT_TRUE(belief.covariance.isApprox(fused));
  EXPECT_TRUE(belief.T_model_base.isApprox(with.lines.step(2)));
}

TEST(PosedLines, AStepOverLinesThatWereForgottenIsAsUncertainAsTheirs) {
  LinesOfASource with;
  with.observations.thin(4);
  ASSERT_TRUE(with.lines.keep_in_step());
  ASSERT_LT(with.lines.size(), 4U);
  for (std::uint32_t i = 1; i < with.lines.size(); ++i) {
    expect_fused(with.lines, i, 1e3 * with.lines.seconds_between(i - 1, i));
  }
}

}  // namespace
}  // namespace ribbon_mapper::slam
