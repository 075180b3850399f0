// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Transforms as people record them. Whatever the bag, bag_check and the modeler agree.

#include <console_bridge/console.h>
#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "modeler/ros/bag_check/bag_check.hpp"
#include "test/bag/wall_bag.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Collects what tf2 would print.
class PrintedByTf : public console_bridge::OutputHandler {
 public:
  PrintedByTf() { console_bridge::useOutputHandler(this); }
  ~PrintedByTf() override { console_bridge::restorePreviousOutputHandler(); }
  void log(const std::string& text, console_bridge::LogLevel, const char*, int) override {
    texts.push_back(text);
  }
  std::vector<std::string> texts;
};

struct Read {
  std::vector<ReadyLine> lines;
  LineLog log;
  TransformCounts counts;
  std::vector<std::string> choices;
  std::string report;
};

class BagTf : public testing::Test {
 protected:
  BagTf() {
    ros::Time::init();
    bag_.is_compressed = false;
  }

  Read read(const WallBag& bag, const BagOptions& options = {}) {
    bag.write(file_);
    Read read;
    BagLines lines({file_}, options, read.log);
    while (auto line = lines.next()) read.lines.push_back(std::move(*line));
    read.counts = lines.transforms().counts(), read.choices = lines.choices();
    const BagReport report = check_bags({file_}, options);
    read.report = report.text();
    EXPECT_EQ(report.can_be_mapped(), !read.lines.empty()) << read.report;
    EXPECT_THAT(printed_.texts, IsEmpty());
    return read;
  }
  /// Expects all lines, with the poses of the unspoilt bag.
  void expect_as_good(const Read& found) {
    WallBag unspoilt;
    unspoilt.is_compressed = false;
    const Read good = read(unspoilt);
    ASSERT_EQ(found.lines.size(), 200u) << found.report;
    for (std::size_t i = 0; i < found.lines.size(); ++i) {
      const LinePoses &a = found.lines[i].poses, &b = good.lines[i].poses;
      ASSERT_TRUE(a.T_map_base.isApprox(b.T_map_base, 1e-9)) << i;
      ASSERT_TRUE(a.T_base_laser_first.isApprox(b.T_base_laser_first, 1e-9)) << i;
    }
  }
  void expect_as_good(const WallBag& bag, const std::string& warning,
                      const BagOptions& options = {}) {
    const Read found = read(bag, options);
    expect_as_good(found);
    EXPECT_THAT(found.report, HasSubstr(warning));
  }
  /// Renames frames in all transforms.
  void rename(const std::map<std::string, std::string>& names) {
    bag_.spoil_static = bag_.spoil_tf = [names](tf2_msgs::TFMessage& message) {
      for (auto& transform : message.transforms) {
        for (std::string* frame : {&transform.header.frame_id, &transform.child_frame_id}) {
          if (names.count(*frame) != 0) *frame = names.at(*frame);
        }
      }
    };
    if (names.count(bag_.laser_frame) != 0) bag_.laser_frame = names.at(bag_.laser_frame);
  }

  TemporaryDirectory directory_;
  std::filesystem::path file_ = directory_.path() / "wall.bag";
  WallBag bag_;
  PrintedByTf printed_;
};

void scale(geometry_msgs::Quaternion& q, double length) {
  q.w *= length, q.x *= length, q.y *= length, q.z *= length;
}

TEST_F(BagTf, QuaternionsAsTf2TakesThem) {
  for (const double length : {1.0016, 1.0041, 0.9960, 1.00495, 0.99505}) {
    bag_.spoil_tf = bag_.spoil_static = [length](tf2_msgs::TFMessage& message) {
      for (auto& transform : message.transforms) scale(transform.transform.rotation, length);
    };
    expect_as_good(bag_, "VERDICT  this can be mapped\n");
  }
}

TEST_F(BagTf, QuaternionsThatTf2RefusesAreNamed) {
  for (const double length : {1.006, 0.994, 0.5, 0.0, std::nan("")}) {
    bag_.spoil_tf = [length](tf2_msgs::TFMessage& message) {
      scale(message.transforms.back().transform.rotation, length);
    };
    const Read found = read(bag_);
    EXPECT_THAT(found.lines, IsEmpty());
    EXPECT_THAT(found.report, HasSubstr("torso_lift_link -> laser_tilt_link: its quaternion has "
                                        "length"));
    EXPECT_THAT(found.report, HasSubstr("0.995 to 1.005"));
  }
}

TEST_F(BagTf, RepeatedTransformsAreOneWarning) {
  bag_.spoil_tf = [](tf2_msgs::TFMessage& message) {
    const auto once = message.transforms;
    message.transforms.insert(message.transforms.end(), once.begin(), once.end());
  };
  expect_as_good(bag_, "repeat the stamp of one before");
  const Read found = read(bag_);
  EXPECT_EQ(found.counts.repeated, 3u * 522u);
  EXPECT_EQ(found.counts.differing, 0u);
  EXPECT_THAT(found.report, HasSubstr("is each recorded twice?"));
  EXPECT_THAT(found.report, Not(HasSubstr("cannot be used")));
}

TEST_F(BagTf, OfTransformsThatDifferTheFirstCounts) {
  bag_.spoil_tf = [](tf2_msgs::TFMessage& message) {
    message.transforms.push_back(message.transforms.front());
    message.transforms.back().transform.translation.x = 5.0;
  };
  expect_as_good(bag_, "522 of them say something else: two nodes publish one frame");
}

TEST_F(BagTf, AFrameBothStaticAndMovingMoves) {
  bag_.spoil_static = [](tf2_msgs::TFMessage& message) {
    message.transforms.push_back(message.transforms.front());
    message.transforms.back().header.frame_id = "torso_lift_link";
    message.transforms.back().child_frame_id = "laser_tilt_link";
  };
  expect_as_good(bag_, "on /tf_static and on /tf: torso_lift_link -> laser_tilt_link; the moving");
  bag_.static_last = true;
  expect_as_good(bag_, "the moving one counts");
}

TEST_F(BagTf, WhenTransformsWereRecordedDoesNotMatter) {
  for (const std::string frame : {"odom_combined", "base_footprint", "laser_tilt_link"}) {
    for (const double late_s : {-3.0, 0.3, 3.0, 30.0, 1000.0}) {
      bag_.late_frame = frame, bag_.late_s = late_s;
      expect_as_good(read(bag_));
    }
  }
}

TEST_F(BagTf, OfTooManyTransformsThoseNeededAreKept) {
  BagOptions options;
  options.max_transforms = 300;
  bag_.spoil_tf = [](tf2_msgs::TFMessage& message) {
    message.transforms.push_back(message.transforms.back());
    message.transforms.back().child_frame_id = "arm";
  };
  expect_as_good(bag_, "VERDICT  this can be mapped\n", options);
}

TEST_F(BagTf, LatenessIsAWarningForTheLiveNode) {
  bag_.late_frame = "odom_combined", bag_.late_s = 3.0;
  expect_as_good(bag_, "map -> odom_combined was recorded 3.0 s later than scans of its time");
  EXPECT_THAT(read(bag_).report, HasSubstr("~transform_timeout"));
}

TEST_F(BagTf, TheOrderOfTransformsDoesNotMatter) {
  std::vector<tf2_msgs::TFMessage> late;
  bag_.spoil_tf = [&](tf2_msgs::TFMessage& message) {  // each is recorded up to 9 places later
    late.push_back(message);
    std::swap(late[(late.size() * 7) % std::min<std::size_t>(late.size(), 10)], late.back());
    message = late.size() > 10 ? late.back() : tf2_msgs::TFMessage();
    if (late.size() > 10) late.pop_back();
  };
  const Read found = read(bag_);
  EXPECT_GT(found.lines.size(), 190u);
}

TEST_F(BagTf, StampsOfAnotherClockBeforeTheFirstOnesDoNotMatter) {
  int count = 0;
  bag_.spoil_tf = [&](tf2_msgs::TFMessage& message) {
    if (++count > 2) return;
    for (auto& transform : message.transforms) transform.header.stamp = ros::Time(1.7e9);
  };
  expect_as_good(read(bag_));
}

TEST_F(BagTf, AGapIsNotBridgedForLong) {
  bag_.tf_gap_begin_s = 1.0, bag_.tf_gap_end_s = 4.0;
  const Read found = read(bag_);
  EXPECT_NEAR(static_cast<double>(found.lines.size()), 160.0, 2.0);  // 2 of the 3 s are bridged
  EXPECT_THAT(found.report, HasSubstr("tf has a gap of 3.0"));
}

TEST_F(BagTf, OtherNamesAreTakenIfThereIsOneChoice) {
  rename({{"odom_combined", "odom"}, {"base_footprint", "base_link"}});
  expect_as_good(bag_, "--odom-frame odom --base-frame base_link is taken");
  rename({{"map", "world"}, {"odom_combined", "odom"}, {"base_footprint", "chassis"}});
  expect_as_good(bag_, "--map-frame world --odom-frame odom --base-frame chassis is taken");
  rename({{"map", "robot1/map"},
          {"odom_combined", "robot1/odom"},
          {"base_footprint", "robot1/base_footprint"},
          {"torso_lift_link", "robot1/torso_lift_link"},
          {"laser_tilt_link", "robot1/laser_tilt_link"}});
  expect_as_good(bag_,
                 "--map-frame robot1/map --odom-frame robot1/odom --base-frame "
                 "robot1/base_footprint is taken");
}

TEST_F(BagTf, AMissingFrameIsReplacedByTheOneBelow) {
  bag_.with_map = false;
  expect_as_good(bag_,
                 "--map-frame odom_combined is taken, the only choice: there is no localisation");
  bag_.spoil_tf = [](tf2_msgs::TFMessage& message) {  // torso_lift_link -> laser_tilt_link
    message.transforms.erase(message.transforms.begin());
  };
  expect_as_good(bag_, "without odometry, the robot is taken to stand still");
}

TEST_F(BagTf, SeveralChoicesAreListed) {
  rename({{"odom_combined", "a"}, {"base_footprint", "b"}, {"map", "c"}});
  const Read found = read(bag_);
  EXPECT_THAT(found.lines, IsEmpty());
  EXPECT_THAT(found.report, HasSubstr("but c -> a -> b -> torso_lift_link -> laser_tilt_link: set "
                                      "--map-frame, --odom-frame and --base-frame"));
  BagOptions options;
  options.intake.frames = {"c", "a", "b"};
  expect_as_good(bag_, "VERDICT  this can be mapped\n", options);
}

TEST_F(BagTf, AFrameThatTheUserNamesIsNotReplaced) {
  BagOptions options;
  options.intake.frames.map = "world";
  options.named_frames.map = true;
  const Read found = read(bag_, options);
  EXPECT_THAT(found.lines, IsEmpty());
  EXPECT_THAT(found.report, HasSubstr("tf has no frame world, but map -> odom_combined"));
}

TEST_F(BagTf, TransformsUnderARobotsName) {
  bag_.tf_space = "/robot1", bag_.scan_topic = "/robot1/tilt_scan";
  expect_as_good(bag_, "there is no /tf: --tf-topic /robot1/tf is taken, the only choice");
  bag_.tf_space = "/a/b";
  expect_as_good(bag_, "--tf-topic /a/b/tf is taken");
  BagOptions options;
  options.tf_topic = "a/b/tf";
  expect_as_good(bag_, "VERDICT  this can be mapped\n", options);
  options.tf_topic = "/robot2/tf";
  bag_.write(file_);
  EXPECT_THAT(check_bags({file_}, options).text(),
              HasSubstr("no transforms on topic /robot2/tf: topics with transforms are /a/b/tf"));
}

TEST_F(BagTf, LongAndStrangeNamesDoNotFillTheMessages) {
  const std::string name = "\x1b[2J\n" + std::string(2'000'000, 'x');
  bag_.lines = 20;
  bag_.spoil_scan = [&](int line, sensor_msgs::LaserScan& scan) {
    if (line % 2 == 1) scan.header.frame_id = name;
    return true;
  };
  bag_.spoil_static = [&](tf2_msgs::TFMessage& message) {
    message.transforms.push_back(message.transforms.front());
    message.transforms.back().child_frame_id = name;
  };
  const Read found = read(bag_);
  EXPECT_EQ(found.lines.size(), 10u);
  EXPECT_LT(found.report.size(), 4000u);
  EXPECT_LT(found.log.newest_drop().size(), 500u);
  EXPECT_THAT(found.report, Not(HasSubstr("\x1b")));
}

TEST_F(BagTf, LostLinesAreCounted) {
  bag_.spoil_scan = [](int line, sensor_msgs::LaserScan& scan) {
    scan.header.seq = static_cast<std::uint32_t>(line);
    return line < 50 || line >= 80;
  };
  const Read counted = read(bag_);
  EXPECT_EQ(counted.log.lost(), 30u);
  EXPECT_EQ(counted.log.gaps(), 0u);
  EXPECT_THAT(counted.report, HasSubstr("30 lines were lost before they were recorded"));
}

}  // namespace
}  // namespace ribbon_mapper
