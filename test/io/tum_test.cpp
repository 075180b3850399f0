// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/io/tum.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Tum, RoundTrip) {
  std::vector<StampedPose> trajectory;
  for (int i = 0; i < 20; ++i) {
    const Pose tilted = Pose(Eigen::AngleAxisd(0.3 * i, Eigen::Vector3d(1, 2, i).normalized()));
    trajectory.push_back({Time(1'700'000'000'123'456'789 + i * 25'000'001LL),
                          planar_pose(0.1 * i, -2.0, 0.5 * i) * tilted});
  }
  const auto back = from_tum(to_tum(trajectory), "text");
  ASSERT_EQ(back.size(), trajectory.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_EQ(back[i].stamp, trajectory[i].stamp);
    EXPECT_TRUE(back[i].T_map_base.isApprox(trajectory[i].T_map_base, 1e-9));
  }
}

TEST(Tum, GoldenLine) {
  EXPECT_EQ(to_tum({{Time(1'500'000'000), planar_pose(1.0, 2.0, 0.0)}}),
            "# stamp tx ty tz qx qy qz qw\n"
            "1.500000000 1.000000000 2.000000000 0.000000000 "
            "0.000000000000 0.000000000000 0.000000000000 1.000000000000\n");
}

TEST(Tum, ReadsWhatOthersWrite) {
  const auto poses = from_tum(
      "# comment\r\n\r\n1305031102.1758 1.3352 0.6261 1.6519 0.6574 0.6126 -0.2949 -0.3248\r\n"
      "1.3050311022e9\t0 0 0 0 0 0 1\n",
      "text");
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[0].stamp, Time(1'305'031'102'175'800'000));
  EXPECT_TRUE(is_valid(poses[0].T_map_base));
}

struct BadLine {
  const char* line;
  const char* reason;
};
class BadText : public testing::TestWithParam<BadLine> {};

TEST_P(BadText, IsRefusedWithItsLineNumber) {
  const std::string text = std::string("# header\n5 0 0 0 0 0 0 1\n") + GetParam().line + "\n";
  EXPECT_THAT([&] { from_tum(text, "loop.tum"); },
              ThrowsMessage<std::runtime_error>(
                  AllOf(HasSubstr("loop.tum, line 3:"), HasSubstr(GetParam().reason))));
}

INSTANTIATE_TEST_SUITE_P(Tum, BadText,
                         testing::Values(BadLine{"6 0 0 0 0 0 0", "8 finite numbers"},
                                         BadLine{"6 0 0 nan 0 0 0 1", "8 finite numbers"},
                                         BadLine{"6 x 0 0 0 0 0 1", "8 finite numbers"},
                                         BadLine{"6 0 0 0 0 0 0 1 9", "more than 8"},
                                         BadLine{"6 0 0 0 0 0 0 0", "quaternion"},
                                         BadLine{"6 0 0 0 0 0 0 2", "quaternion"},
                                         BadLine{"5 0 0 0 0 0 0 1", "not later"},
                                         BadLine{"1e30 0 0 0 0 0 0 1", "too large"},
                                         BadLine{"6 1e300 0 0 0 0 0 1", "more than 1e9 m"},
                                         BadLine{"6 0 -1e19 0 0 0 0 1", "more than 1e9 m"},
                                         BadLine{"6 0 0 1000000001 0 0 0 1", "more than 1e9 m"},
                                         BadLine{"6 0,5 0 0 0 0 0 1", "8 finite numbers"}));

TEST(Tum, FarPosesKeepTheirDigits) {
  const Pose utm = planar_pose(690'123.123456789, 5'334'567.987654321, 0.5);
  const auto back = from_tum(to_tum({{Time(1), utm}}), "text");
  EXPECT_TRUE(back.at(0).T_map_base.isApprox(utm, 1e-15));
  const Pose largest = planar_pose(1e9, -1e9, 0.0);
  EXPECT_EQ(from_tum(to_tum({{Time(1), largest}}), "text").at(0).T_map_base.translation(),
            largest.translation());
}

TEST(Tum, WhatCannotBeReadAgainIsWrittenInWholeLines) {
  const std::string text = to_tum({{Time(1), planar_pose(1e300, -1e300, 0.0)}});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
  EXPECT_THROW(from_tum(text, "text"), std::runtime_error);
}

TEST(Tum, StatesItsRun) {
  EXPECT_EQ(to_tum({}, "0123456789abcdef"),
            "# run 0123456789abcdef\n# stamp tx ty tz qx qy qz qw\n");
  EXPECT_TRUE(from_tum(to_tum({}, "0123456789abcdef"), "text").empty());
}

TEST(Tum, NegativeStampsComeBack) {
  const std::vector<StampedPose> early{{Time(-1'500'000'001), Pose::Identity()},
                                       {Time(-1), Pose::Identity()}};
  const auto back = from_tum(to_tum(early), "text");
  EXPECT_EQ(back.at(0).stamp, early[0].stamp);
  EXPECT_EQ(back.at(1).stamp, early[1].stamp);
}

TEST(Tum, FilesThatCannotBeReadAreNamed) {
  const TemporaryDirectory directory;
  EXPECT_THAT([] { read_tum("/nowhere/loop.tum"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("/nowhere/loop.tum: No such file")));
  EXPECT_THROW(read_tum(directory.path()), std::runtime_error);
}

TEST(Tum, CovariancesAreATableOfTheirUpperTriangles) {
  Matrix6 covariance = Matrix6::Zero();
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) {
      covariance(row, column) = std::max(row, column) + 0.1 * std::min(row, column);
    }
  }
  EXPECT_EQ(to_covariance_csv({{Time(1'500'000'000), Pose::Identity()}}, {covariance}, "abc"),
            "# run abc\n"
            "stamp,x_x,x_y,x_z,x_roll,x_pitch,x_yaw,y_y,y_z,y_roll,y_pitch,y_yaw,"
            "z_z,z_roll,z_pitch,z_yaw,roll_roll,roll_pitch,roll_yaw,pitch_pitch,pitch_yaw,yaw_yaw\n"
            "1.500000000,0.000000e+00,1.000000e+00,2.000000e+00,3.000000e+00,4.000000e+00,"
            "5.000000e+00,1.100000e+00,2.100000e+00,3.100000e+00,4.100000e+00,5.100000e+00,"
            "2.200000e+00,3.200000e+00,4.200000e+00,5.200000e+00,3.300000e+00,4.300000e+00,"
            "5.300000e+00,4.400000e+00,5.400000e+00,5.500000e+00\n");
  EXPECT_EQ(to_covariance_csv({}, {}).substr(0, 10), "stamp,x_x,");
  EXPECT_THROW(to_covariance_csv({}, {covariance}), std::invalid_argument);
}

}  // namespace
}  // namespace ribbon_mapper
