// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/lines/posed_lines.hpp"

#include <gtest/gtest.h>

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

/// Twice the way, and a count of the questions.
class TwiceTheWay : public OdometrySource {
 public:
  RefinedPose refined(Time, const Pose& recorded) const override {
    ++questions;
    return {Pose(Eigen::Translation3d(2.0 * recorded.translation())),
            recorded.translation().x() != 1.0};
  }
  mutable int questions = 0;
};

TEST(PosedLines, TakeTheStepsOfASourceAndAskItOncePerLine) {
  Observations observations({});
  for (const int ribbons : {3, 3, 3, 3}) add_line(observations, ribbons);
  const TwiceTheWay source;
  PosedLines lines(observations, &source);
  EXPECT_FALSE(lines.keep_in_step());
  while (lines.has_next()) lines.add_next();
  EXPECT_TRUE(lines.step(2).isApprox(planar_pose(2.0, 0.0, 0.0)));
  EXPECT_EQ(source.questions, 4);
  EXPECT_TRUE(lines.is_bare(1));
  EXPECT_FALSE(lines.is_bare(2));
  lines.set_bare_ratio(3.0);
  EXPECT_DOUBLE_EQ(lines.noise_of(1, {}).planar_scale, 3.0);
  EXPECT_DOUBLE_EQ(lines.noise_of(2, {}).planar_scale, 1.0);
  observations.thin(4);
  ASSERT_TRUE(lines.keep_in_step());
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    const double number = static_cast<double>(lines.stamp(i).count()) / 1e6;
    EXPECT_DOUBLE_EQ(lines.T_odom_base(i).translation().x(), 2.0 * number);
  }
  EXPECT_EQ(source.questions, 4);
}

}  // namespace
}  // namespace ribbon_mapper::slam
