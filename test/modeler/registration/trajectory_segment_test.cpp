// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/registration/trajectory_segment.hpp"

#include <gtest/gtest.h>

#include <string>

#include "test/modeler/registration/hall.hpp"

namespace ribbon_mapper {
namespace {

/// Where odometry is at a time: on a path that turns in space.
Pose odometry_at(double time_s) {
  return Eigen::Translation3d(0.3 * time_s, 0.05 * time_s * time_s, -0.1 * time_s) *
         Eigen::AngleAxisd(0.2 * time_s, Eigen::Vector3d(0.1, 0.2, 1.0).normalized());
}

/// The corrected pose of a time.
Pose corrected_at(double time_s) { return hall::any_pose(1) * odometry_at(time_s); }

TrackedPoses poses_at(const std::vector<double>& times_s, Pose (*in_map)(double)) {
  TrackedPoses poses;
  for (const double time_s : times_s) {
    poses.push_back({{from_seconds(time_s), in_map(time_s)}, odometry_at(time_s)});
  }
  return poses;
}

std::vector<TrajectorySegment> segments(const std::vector<double>& lines_s,
                                        const std::vector<double>& corrected_s) {
  return segments_between(poses_at(lines_s, odometry_at), poses_at(corrected_s, corrected_at));
}

/// The segments' lines, an open end as '.', a known one as '|': "|0 1|" or ".3 4 5|".
std::string picture(const std::vector<double>& lines_s, const std::vector<double>& corrected_s) {
  std::string text;
  for (const TrajectorySegment& segment : segments(lines_s, corrected_s)) {
    text += segment.T_frame_start ? "|" : ".";
    for (std::uint32_t i = segment.first_line; i < segment.end_line; ++i) {
      text += (i > segment.first_line ? " " : "") + std::to_string(i);
    }
    text += segment.T_frame_end ? "|" : ".";
    EXPECT_EQ(segment.end_line - segment.first_line, segment.lines());
    EXPECT_EQ(segment.lines() + 1, segment.steps.size());
    EXPECT_TRUE(segment.step_variances.empty());
    EXPECT_EQ(!segment.T_frame_start || !segment.T_frame_end, segment.is_open());
  }
  return text;
}

TEST(SegmentsBetween, CorrectedPosesDivideTheLines) {
  EXPECT_EQ(".0 1||2 3||4.", picture({1, 2, 3, 4, 5}, {2.5, 4.5}));
}

TEST(SegmentsBetween, ALineAtTheStampOfACorrectedPoseIsInNone) {
  EXPECT_EQ(".0||2||4.", picture({1, 2, 3, 4, 5}, {2, 4}));
  EXPECT_EQ("|1 2 3|", picture({1, 2, 3, 4, 5}, {1, 5})) << "no segment beyond the ends";
}

TEST(SegmentsBetween, PosesWithoutALineBetweenThemGiveNone) {
  EXPECT_EQ(".0||1 2.", picture({1, 2, 3}, {1.2, 1.4, 1.6}));
  EXPECT_EQ("", picture({1, 2, 3}, {1, 2, 3}));
}

TEST(SegmentsBetween, OneLineOrOneCorrectedPoseOrNoLineAtAll) {
  EXPECT_EQ("|0|", picture({2}, {1, 3}));
  EXPECT_EQ("", picture({2}, {2}));
  EXPECT_EQ(".0 1||2.", picture({1, 2, 3}, {2.5}));
  EXPECT_EQ("", picture({}, {1}));
}

TEST(SegmentsBetween, CorrectedPosesOutsideOfTheLinesAreEndsToo) {
  EXPECT_EQ("|0 1|", picture({1, 2}, {0.5, 2.5}));
}

TEST(SegmentsBetween, StepsAndEndsAreThoseOfTheOdometryAndTheCorrection) {
  const TrajectorySegment segment = segments({1, 2, 3, 4, 5}, {1.5, 4.5}).at(1);
  const std::vector<double> times{1.5, 2, 3, 4, 4.5};
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const Pose expected = odometry_at(times[i]).inverse() * odometry_at(times[i + 1]);
    EXPECT_LT(hall::difference(expected, segment.steps[i]), 1e-12) << i;
  }
  EXPECT_LT(hall::difference(corrected_at(1.5), *segment.T_frame_start), 1e-12);
  EXPECT_LT(hall::difference(corrected_at(4.5), *segment.T_frame_end), 1e-12);
}

TEST(SegmentsBetween, AnOpenEndLiesAtItsNextLine) {
  const auto both = segments({1, 2, 3, 4}, {2.5});
  EXPECT_LT(hall::difference(Pose::Identity(), both.at(0).steps.front()), 1e-12);
  EXPECT_LT(hall::difference(Pose::Identity(), both.at(1).steps.back()), 1e-12);
  EXPECT_LT(hall::difference(corrected_at(2.5), *both[0].T_frame_end), 1e-12);
  EXPECT_LT(hall::difference(corrected_at(2.5), *both[1].T_frame_start), 1e-12);
}

TEST(InFrame, MovesTheEndsAndNothingElse) {
  const Pose T_map_model = hall::any_pose(2);
  const TrajectorySegment in_map = segments({1, 2, 3, 4, 5}, {1.5, 4.5}).at(1);
  const TrajectorySegment in_model = in_frame(in_map, T_map_model);
  EXPECT_LT(hall::difference(*in_map.T_frame_start, T_map_model * *in_model.T_frame_start), 1e-12);
  EXPECT_LT(hall::difference(*in_map.T_frame_end, T_map_model * *in_model.T_frame_end), 1e-12);
  EXPECT_EQ(in_map.first_line, in_model.first_line);
  EXPECT_EQ(in_map.end_line, in_model.end_line);
  for (std::size_t i = 0; i < in_map.steps.size(); ++i) {
    EXPECT_EQ(in_map.steps[i].matrix(), in_model.steps[i].matrix());
  }
}

TEST(InFrame, LeavesAnOpenEndOpen) {
  const auto both = segments({1, 2, 3, 4}, {2.5});
  EXPECT_FALSE(in_frame(both.at(0), hall::any_pose(2)).T_frame_start);
  EXPECT_FALSE(in_frame(both.at(1), hall::any_pose(2)).T_frame_end);
}

}  // namespace
}  // namespace ribbon_mapper
