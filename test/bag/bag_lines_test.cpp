// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag/bag_lines.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "modeler/modeler.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "test/bag/wall_bag.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

using testing::HasSubstr;

struct Lines {
  std::vector<ReadyLine> lines;
  LineLog log;
};

Lines lines_of(const std::vector<std::filesystem::path>& files, const BagOptions& options = {}) {
  ros::Time::init();
  Lines result;
  BagLines source(files, options, result.log);
  while (auto line = source.next()) result.lines.push_back(std::move(*line));
  return result;
}

class BagLinesTest : public testing::Test {
 protected:
  std::filesystem::path written(const WallBag& bag, const std::string& name = "a.bag") {
    bag.write(directory_.path() / name);
    return directory_.path() / name;
  }
  TemporaryDirectory directory_;
  WallBag bag_;
};

TEST_F(BagLinesTest, EachLineComesWithItsPoses) {
  const Lines found = lines_of({written(bag_)});
  ASSERT_EQ(found.lines.size(), 200u);
  EXPECT_EQ(found.log.lines(), 200u);
  EXPECT_EQ(found.log.dropped_lines(), 0u);
  const ReadyLine& first = found.lines.front();
  EXPECT_EQ(first.beams.stamp, std::chrono::seconds(1000));
  EXPECT_NEAR(first.poses.T_base_laser_first.translation().z(), 1.2, 1e-9);
  EXPECT_NEAR(angle_of(first.poses.T_base_laser_first), 0.3, 1e-6);
}

TEST_F(BagLinesTest, CompressedOrNotIsTheSame) {
  const Lines compressed = lines_of({written(bag_)});
  bag_.is_compressed = false;
  EXPECT_EQ(lines_of({written(bag_, "b.bag")}).lines.size(), compressed.lines.size());
}

TEST_F(BagLinesTest, StaticTransformsAreReadFirst) {
  bag_.static_last = true;
  EXPECT_EQ(lines_of({written(bag_)}).lines.size(), 200u);
}

TEST_F(BagLinesTest, LeadingSlashesDoNotMatter) {
  bag_.slash = "/";
  bag_.laser_frame = "/laser_tilt_link";
  EXPECT_EQ(lines_of({written(bag_)}).lines.size(), 200u);
}

TEST_F(BagLinesTest, PartsOfARecordingAreReadAsOne) {
  WallBag scans = bag_, transforms = bag_;
  scans.with_tf = scans.with_static = false;
  // WallBag ends tf with the last line, so this bag has lines on another topic.
  transforms.lines = 200;
  transforms.scan_topic = "/base_scan";
  const auto a = written(scans, "scans.bag"), b = written(transforms, "tf.bag");
  EXPECT_EQ(lines_of({a, b}).lines.size(), 200u);
  EXPECT_EQ(lines_of({b, a}).lines.size(), 200u);
}

TEST_F(BagLinesTest, TheOffsetIsAddedToStamps) {
  BagOptions options;
  options.intake.scan_time_offset_s = 0.02;
  const Lines found = lines_of({written(bag_)}, options);
  EXPECT_EQ(found.lines.front().beams.stamp, std::chrono::milliseconds(1'000'020));
}

TEST_F(BagLinesTest, DropsAreCountedByReason) {
  bag_.spoil_scan = [](int line, sensor_msgs::LaserScan& scan) {
    if (line == 10) scan.ranges.clear();
    if (line == 20) scan.ranges.assign(10000, 1.0F);
    if (line == 30) scan.header.stamp = ros::Time(900.0);
    if (line == 40) scan.header.frame_id = "/nowhere";
    return true;
  };
  const Lines found = lines_of({written(bag_)});
  EXPECT_EQ(found.lines.size(), 196u);
  EXPECT_EQ(found.log.dropped_by_reason().at("malformed"), 2u);
  EXPECT_EQ(found.log.dropped_by_reason().at("out of order"), 1u);
  EXPECT_EQ(found.log.dropped_by_reason().at("frame nowhere is not in tf"), 1u);
}

TEST_F(BagLinesTest, FramesCanBeLeftOutOfTf) {
  BagOptions options;
  options.tf_drop_frames = {"map"};
  options.named_frames.map = true;
  const Lines found = lines_of({written(bag_)}, options);
  EXPECT_TRUE(found.lines.empty());
  EXPECT_EQ(found.log.dropped_by_reason().at("frame map is not in tf"), 200u);
  options.intake.frames.map = "odom_combined";  // odometry in place of a localisation
  EXPECT_EQ(lines_of({written(bag_)}, options).lines.size(), 200u);
}

TEST_F(BagLinesTest, TransformsThatLoopDoNotHang) {
  bag_.spoil_tf = [](tf2_msgs::TFMessage& message) {
    message.transforms[1].header.frame_id = "laser_tilt_link";
  };
  EXPECT_TRUE(lines_of({written(bag_)}).lines.empty());
}

TEST_F(BagLinesTest, AScanFarAheadCostsOnlyItself) {
  bag_.spoil_scan = [](int line, sensor_msgs::LaserScan& scan) {
    if (line == 50) scan.header.stamp = ros::Time(4e9);
    return true;
  };
  EXPECT_EQ(lines_of({written(bag_)}).lines.size(), 199u);
}

TEST(TfTopics, OfSeveralRobotsThatOfTheScansIsTaken) {
  const std::string md5 = ros::message_traits::md5sum<tf2_msgs::TFMessage>();
  const std::vector<BagTopic> topics{{"/robot1/tf", "tf2_msgs/TFMessage", md5, 5},
                                     {"/robot2/tf", "tf/tfMessage", md5, 5},
                                     {"/robot2/tf_static", "tf2_msgs/TFMessage", md5, 1}};
  EXPECT_EQ(tf_topics_of(topics, "", "/robot2/scan").moving.front(), "/robot2/tf");
  EXPECT_EQ(tf_topics_of(topics, "", "/robot2/scan").fixed.front(), "/robot2/tf_static");
  EXPECT_THAT(tf_topics_of(topics, "", "/scan").note, HasSubstr("one of /robot1/tf, /robot2/tf"));
}

TEST(ScanTopic, IsChosenOrAskedFor) {
  const std::string md5 = ros::message_traits::md5sum<sensor_msgs::LaserScan>();
  const BagTopic tilt{"/tilt_scan", "sensor_msgs/LaserScan", md5, 5};
  const BagTopic base{"/base_scan", "sensor_msgs/LaserScan", md5, 5};
  const BagTopic other{"/points", "sensor_msgs/PointCloud2", "x", 5};
  EXPECT_EQ(scan_topic_of({base, other}, ""), "/base_scan");
  EXPECT_EQ(scan_topic_of({base, tilt}, ""), "/tilt_scan");
  EXPECT_EQ(scan_topic_of({base, tilt}, "base_scan"), "/base_scan");
  const auto complaint = [](const std::vector<BagTopic>& topics, const std::string& wanted) {
    try {
      return "chose " + scan_topic_of(topics, wanted);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
  };
  BagTopic front = tilt;
  front.name = "/front_scan";
  EXPECT_THAT(complaint({base, front}, ""), HasSubstr("/base_scan, /front_scan"));
  EXPECT_THAT(complaint({base, other}, "points"), HasSubstr("carries sensor_msgs/PointCloud2"));
  EXPECT_THAT(complaint({other}, ""), HasSubstr("no topic with sensor_msgs/LaserScan"));
  EXPECT_THAT(complaint({base}, "tilt"), HasSubstr("no topic tilt"));
}

}  // namespace
}  // namespace ribbon_mapper
