// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The recording of a simulated robot with both lasers, beside one without its base laser.
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_msgs/TFMessage.h>

#include <vector>

#include "modeler/ros/bag_check/bag_check.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "sim/ros/tour_recorder.hpp"
#include "test/io/temporary_directory.hpp"

namespace ribbon_mapper {
namespace {

namespace fs = std::filesystem;

constexpr double kLongest_s = 5.0;

fs::path recorded(const TemporaryDirectory& directory, bool base_laser) {
  ros::Time::init();
  const sim::World world = sim::World::load(PROJECT_DIR "/test/ros/room.sdf", {});
  sim::Tour tour(world, sim::Route::load(PROJECT_DIR "/test/ros/room.route.yaml"), {});
  const fs::path file = directory.path() / (base_laser ? "both.bag" : "tilting.bag");
  sim::RecorderOptions recorder;
  recorder.longest_s = kLongest_s;
  recorder.base_laser = base_laser;
  sim::record_tour(tour, recorder, file);
  return file;
}

/// The bytes of a message with its topic and time.
struct Recorded {
  std::string topic;
  ros::Time time;
  std::vector<std::uint8_t> bytes;
  bool operator==(const Recorded& other) const {
    return topic == other.topic && time == other.time && bytes == other.bytes;
  }
};

/// Returns all messages but those of the base laser.
std::vector<Recorded> without_base_laser(const fs::path& file) {
  std::vector<Recorded> messages;
  rosbag::Bag bag(file.string());
  for (const rosbag::MessageInstance& message : rosbag::View(bag)) {
    const auto tf = message.instantiate<tf2_msgs::TFMessage>();
    const bool is_its_tf = tf && tf->transforms.at(0).child_frame_id == "base_laser_link";
    if (is_its_tf || message.getTopic() == "/base_scan") continue;
    messages.push_back({message.getTopic(), message.getTime(), {}});
    messages.back().bytes.resize(message.size());
    ros::serialization::OStream stream(messages.back().bytes.data(), message.size());
    message.write(stream);
  }
  return messages;
}

TEST(BaseLaser, IsRecordedAsThePr2DoesIt) {
  const TemporaryDirectory directory;
  rosbag::Bag bag(recorded(directory, true).string());
  int scans = 0;
  for (const rosbag::MessageInstance& message :
       rosbag::View(bag, rosbag::TopicQuery("/base_scan"))) {
    const auto scan = message.instantiate<sensor_msgs::LaserScan>();
    ASSERT_TRUE(scan);
    EXPECT_EQ(scan->header.frame_id, "base_laser_link");
    EXPECT_NEAR((scan->header.stamp - stamp_of(sim::kTourStart)).toSec(), 0.025 * scans, 1e-6);
    EXPECT_GE(message.getTime().toSec(), scan->header.stamp.toSec() + 1039 * scan->time_increment)
        << "a driver sends a scan when its last beam is in";
    EXPECT_EQ(scan->ranges.size(), 1040U);
    EXPECT_NEAR(scan->angle_min, -130.0 * M_PI / 180.0, 0.005);
    EXPECT_NEAR(scan->angle_max, 130.0 * M_PI / 180.0, 0.005);
    ++scans;
  }
  EXPECT_EQ(scans, 200) << "40 Hz";
}

TEST(BaseLaser, HasItsStaticTransform) {
  const TemporaryDirectory directory;
  rosbag::Bag bag(recorded(directory, true).string());
  for (const rosbag::MessageInstance& message :
       rosbag::View(bag, rosbag::TopicQuery("/tf_static"))) {
    const auto transform = message.instantiate<tf2_msgs::TFMessage>()->transforms.at(0);
    if (transform.child_frame_id != "base_laser_link") continue;
    EXPECT_EQ(transform.header.frame_id, "base_footprint");
    EXPECT_NEAR(transform.transform.translation.x, 0.275, 1e-9);
    EXPECT_NEAR(transform.transform.translation.z, 0.303, 1e-9);
    EXPECT_NEAR(transform.transform.rotation.w, 1.0, 1e-9) << "level";
    return;
  }
  FAIL() << "there is none";
}

TEST(BaseLaser, ChangesNoOtherMessage) {
  const TemporaryDirectory directory;
  const auto both = without_base_laser(recorded(directory, true)),
             tilting = without_base_laser(recorded(directory, false));
  EXPECT_GT(tilting.size(), 1000U);
  EXPECT_TRUE(both == tilting);
}

TEST(BaseLaser, PassesTheCheckOfTheBag) {
  const TemporaryDirectory directory;
  const fs::path file = recorded(directory, true);
  const BagReport report = check_bags({file}, {});
  EXPECT_TRUE(report.can_be_mapped()) << report.text();
  EXPECT_EQ(report.count(Finding::Weight::warning), 0U) << report.text();
}

}  // namespace
}  // namespace ribbon_mapper
