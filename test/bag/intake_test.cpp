// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines that never came, transforms that contradict each other, trajectories that turn otherwise.

#include <console_bridge/console.h>
#include <gmock/gmock.h>

#include "modeler/ros/intake/input_watch.hpp"
#include "modeler/ros/intake/line_gaps.hpp"
#include "modeler/ros/intake/line_intake.hpp"
#include "modeler/ros/intake/transform_buffer.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/node/turn_check.hpp"

namespace ribbon_mapper {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Feeds lines at 40 Hz; `seq_of` gives header.seq of each line.
template <typename Seq, typename Keep>
LineGap total_of(const Seq& seq_of, const Keep& is_kept) {
  LineGaps gaps;
  LineGap total;
  for (std::uint32_t line = 0; line < 400; ++line) {
    if (!is_kept(line)) continue;
    const LineGap gap = gaps.saw(seq_of(line), ros::Time(1000.0 + 0.025 * line));
    total.lost += gap.lost, total.silent_s += gap.silent_s;
  }
  return total;
}

const auto kCounting = [](std::uint32_t line) { return 4294967200U + line; };  // wraps
const auto kConstant = [](std::uint32_t) { return 0U; };

TEST(AttentiveClock, APauseOfTheNodeIsNoWaitOfItsLines) {
  AttentiveClock clock;
  const auto wall_s = [&](double shown_s) {
    return clock.at({ros::Time(7.0), ros::WallTime(shown_s)}).wall.toSec();
  };
  EXPECT_DOUBLE_EQ(wall_s(1000.0), 1000.0);
  EXPECT_DOUBLE_EQ(wall_s(1000.02), 1000.02);
  EXPECT_DOUBLE_EQ(wall_s(1000.04), 1000.04);
  EXPECT_NEAR(wall_s(1030.04), 1000.14, 1e-9);  // 30 s in which nothing was read
  EXPECT_NEAR(wall_s(1030.06), 1000.16, 1e-9);
  EXPECT_NEAR(wall_s(1000.0), 1000.16, 1e-9);  // the wall clock was set back
  EXPECT_EQ(clock.at({ros::Time(8.0), ros::WallTime(1001.0)}).data, ros::Time(8.0));
}

TEST(LineGaps, NothingIsMissing) {
  const auto all = [](std::uint32_t) { return true; };
  EXPECT_EQ(total_of(kCounting, all).lost, 0u);
  EXPECT_EQ(total_of(kCounting, all).silent_s, 0.0);
  EXPECT_EQ(total_of(kConstant, all).silent_s, 0.0);
}

TEST(LineGaps, LinesLostOnTheWayAreCountedBySequence) {
  const auto stall = [](std::uint32_t line) { return line < 100 || line >= 350; };
  EXPECT_EQ(total_of(kCounting, stall).lost, 250u);
  const auto every_third = [](std::uint32_t line) { return line % 3 == 0; };
  EXPECT_NEAR(static_cast<double>(total_of(kCounting, every_third).lost), 266.0, 14.0);
  const auto one = [](std::uint32_t line) { return line != 200; };
  EXPECT_EQ(total_of(kCounting, one).lost, 1u);
}

TEST(LineGaps, WithoutSequenceTimeIsCounted) {
  const auto stall = [](std::uint32_t line) { return line < 100 || line >= 300; };
  EXPECT_NEAR(total_of(kConstant, stall).silent_s, 5.025, 1e-6);
  EXPECT_EQ(total_of(kConstant, stall).lost, 0u);
}

TEST(LineGaps, ASilentLaserLosesNothing) {
  LineGaps gaps;
  for (std::uint32_t i = 0; i < 20; ++i) gaps.saw(i, ros::Time(1000.0 + 0.025 * i));
  const LineGap gap = gaps.saw(20, ros::Time(1010.0));
  EXPECT_EQ(gap.lost, 0u);
  EXPECT_GT(gap.silent_s, 9.0);
}

TEST(LineGaps, TwoPublishersOrARestartOneLoseNothing) {
  const auto two = [](std::uint32_t line) { return line % 2 == 0 ? line / 2 : 5000 + line / 2; };
  const auto all = [](std::uint32_t) { return true; };
  EXPECT_EQ(total_of(two, all).lost, 0u);
  EXPECT_EQ(total_of(two, all).silent_s, 0.0);
  const auto restarted = [](std::uint32_t line) { return line < 200 ? line + 70000 : line - 200; };
  EXPECT_EQ(total_of(restarted, all).lost, 0u);
}

TEST(LineGaps, LinesThatCannotBeUsedAreNotLost) {
  LineGaps gaps;
  for (std::uint32_t i = 0; i < 20; ++i) gaps.saw(i, ros::Time(1000.0 + 0.025 * i));
  gaps.saw_unusable();                                    // line 20
  EXPECT_EQ(gaps.saw(21, ros::Time(1000.4)).lost, 0u);    // out of order
  EXPECT_EQ(gaps.saw(23, ros::Time(1000.575)).lost, 1u);  // 22 is
}

geometry_msgs::TransformStamped transform(const char* parent, const char* child, double stamp_s,
                                          double x_m = 0.0) {
  geometry_msgs::TransformStamped message;
  message.header.frame_id = parent, message.child_frame_id = child;
  message.header.stamp = ros::Time(stamp_s);
  message.transform.translation.x = x_m, message.transform.rotation.w = 1.0;
  return message;
}

tf2_msgs::TFMessage message_of(const std::vector<geometry_msgs::TransformStamped>& transforms) {
  tf2_msgs::TFMessage message;
  message.transforms = transforms;
  return message;
}

class Buffer : public testing::Test {
 protected:
  Buffer() { ros::Time::init(); }
  double x_at(double stamp_s) const {
    return tf_.core().lookupTransform("a", "b", ros::Time(stamp_s)).transform.translation.x;
  }
  TransformBuffer tf_{120.0, {}};
};

TEST_F(Buffer, TheMovingTransformCounts) {
  const auto fixed = message_of({transform("a", "b", 0.0, 7.0), transform("b", "c", 0.0)});
  tf_.add(fixed, true);
  for (int i = 0; i < 5; ++i) tf_.add(message_of({transform("a", "b", 100.0 + i, i)}), false);
  EXPECT_NEAR(x_at(102.5), 2.5, 1e-9);
  EXPECT_TRUE(tf_.core().canTransform("a", "c", ros::Time(101.0)));
  EXPECT_THAT(tf_.contradicted(), ElementsAre("b"));
  tf_.add(fixed, true);  // a new publisher of /tf_static
  EXPECT_NEAR(x_at(102.5), 2.5, 1e-9);
}

TEST_F(Buffer, RepetitionsAreCountedAndTheFirstCounts) {
  for (int i = 0; i < 5; ++i) {
    tf_.add(message_of({transform("a", "b", 100.0 + i, i), transform("a", "b", 100.0 + i, i)}),
            false);
  }
  EXPECT_EQ(tf_.counts().repeated, 5u);
  EXPECT_EQ(tf_.counts().differing, 0u);
  tf_.add(message_of({transform("a", "b", 102.0, 9.0), transform("z", "b", 103.0, 3.0)}), false);
  EXPECT_EQ(tf_.counts().repeated, 7u);
  EXPECT_EQ(tf_.counts().differing, 2u);
  EXPECT_EQ(tf_.counts().refused, 0u);
  EXPECT_NEAR(x_at(102.0), 2.0, 1e-9);
}

TEST_F(Buffer, OldTransformsAreCountedAsSuch) {
  tf_.add(message_of({transform("a", "b", 1000.0)}), false);
  tf_.add(message_of({transform("a", "b", 100.0)}), false);
  EXPECT_EQ(tf_.counts().refused, 1u);
  EXPECT_THAT(tf_.counts().defect, HasSubstr("a -> b: it is older than tf is kept"));
}

TEST_F(Buffer, TheLatestTransformsAreNamed) {
  LineLog log;
  LineIntake intake({}, log);
  InputWatch watch("scan");
  sensor_msgs::LaserScan scan;
  scan.header.frame_id = "laser";
  watch.saw(scan);
  const double now_s = ros::Time::now().toSec();
  tf_.add(message_of({transform("odom_combined", "base_footprint", now_s - 0.1),
                      transform("base_footprint", "laser", now_s)}),
          false);
  EXPECT_EQ(watch.lateness(intake, tf_), "");
  tf_.add(message_of({transform("map", "odom_combined", now_s - 3.0)}), false);
  EXPECT_THAT(watch.lateness(intake, tf_), HasSubstr("Transforms of odom_combined come 3.0 s after "
                                                     "their stamps, and lines wait 2.0 s: raise "
                                                     "~transform_timeout"));
}

/// A robot that turns to and fro by 60 degrees.
double heading_at(double seconds) { return 1.05 * std::sin(0.5 * seconds); }

class Turns : public testing::Test {
 protected:
  Turns() {
    for (int i = 0; i < 600; ++i) {
      const double seconds = 0.05 * i;
      check_.add(from_seconds(100.0 + seconds),
                 planar_pose(0.1 * seconds, 0.0, heading_at(seconds)));
    }
  }
  /// Returns what is said about a trajectory with a pose each `step_s`.
  template <typename Turned>
  std::string said(const Turned& turned, double step_s = 0.025) const {
    std::vector<StampedPose> trajectory;
    for (double seconds = 0.0; seconds < 29.0; seconds += step_s) {
      Pose pose = Pose::Identity();
      pose.linear() = turned(heading_at(seconds), seconds).toRotationMatrix();
      trajectory.push_back({from_seconds(100.0 + seconds), pose});
    }
    return check_.contradiction(trajectory).value_or("");
  }
  TurnCheck check_;
};

Eigen::Quaterniond about(const Eigen::Vector3d& axis, double angle_rad) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, axis));
}

TEST_F(Turns, ACorrectionOfDriftAgrees) {
  for (const double step_s : {0.025, 0.5, 2.0}) {
    EXPECT_EQ("", said(
                      [](double yaw, double s) {
                        return about(Eigen::Vector3d::UnitZ(), 1.1 * yaw + 0.02 * s + 2.0);
                      },
                      step_s));
  }
}

TEST_F(Turns, OtherConventionsContradict) {
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const auto mirrored = [&](double yaw, double) { return about(z, -yaw); };
  EXPECT_THAT(said(mirrored), HasSubstr("the turns of the trajectory contradict the odometry"));
  EXPECT_THAT(said(mirrored, 1.0), HasSubstr("contradict"));
  const auto without = [&](double, double) { return about(z, 0.0); };
  EXPECT_THAT(said(without), HasSubstr("it turns by 0 degrees"));
  const auto camera = [&](double yaw, double) {
    return about(z, yaw) * Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5);
  };
  EXPECT_THAT(said(camera), HasSubstr("not of a sensor"));
  const auto w_first = [&](double yaw, double) {
    const Eigen::Quaterniond q = about(z, yaw);
    return Eigen::Quaterniond(q.z(), q.w(), q.x(), q.y());
  };
  EXPECT_THAT(said(w_first), HasSubstr("x y z w"));
}

TEST_F(Turns, WithoutTurnsNothingCanBeSaid) {
  TurnCheck straight;
  std::vector<StampedPose> trajectory;
  for (int i = 0; i < 100; ++i) {
    straight.add(from_seconds(0.1 * i), planar_pose(0.1 * i, 0.0, 0.0));
    trajectory.push_back({from_seconds(0.1 * i), planar_pose(0.1 * i, 0.0, 0.1)});
  }
  EXPECT_FALSE(straight.contradiction(trajectory));
}

TEST(Shown, IsShortAndPrintable) {
  EXPECT_EQ(shown("base_link"), "base_link");
  EXPECT_EQ(shown("a\n\x1b"
                  "b"),
            "a??b");
  EXPECT_EQ(shown(std::string(2'000'000, 'x')).size(), 83u);
}

}  // namespace
}  // namespace ribbon_mapper
