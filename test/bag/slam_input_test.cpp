// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <nav_msgs/Path.h>

#include "modeler/ros/intake/input_watch.hpp"
#include "modeler/ros/intake/time_jump.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/messages/transform_entry.hpp"
#include "modeler/ros/slam_adapter/rtabmap_graph.hpp"
#include "modeler/ros/slam_adapter/tf_history.hpp"
#include "modeler/ros/slam_adapter/wire_reader.hpp"

namespace ribbon_mapper {
namespace {

using testing::HasSubstr;

template <typename Message>
std::vector<std::uint8_t> bytes_of(const Message& message) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

template <typename... Parts>
std::vector<std::uint8_t> joined(const Parts&... parts) {
  std::vector<std::uint8_t> all;
  const auto add = [&](const std::vector<std::uint8_t>& bytes) {
    all.insert(all.end(), bytes.begin(), bytes.end());
  };
  (add(bytes_of(parts)), ...);
  return all;
}

TEST(WireReader, ReadsAKnownMessageByItsDefinition) {
  nav_msgs::Path path;
  path.header.frame_id = "map";
  path.poses.resize(2);
  path.poses[1].pose.position.x = 2.5;
  path.poses[1].header.stamp = ros::Time(7, 500000000);
  std::vector<double> x, stamps;
  const auto bytes = bytes_of(path);
  const WireReader reader(ros::message_traits::definition<nav_msgs::Path>());
  const auto visit = [&](const std::string& name, double value) {
    if (name == "poses.pose.position.x") x.push_back(value);
    if (name == "poses.header.stamp") stamps.push_back(value);
  };
  reader.read(bytes.data(), bytes.size(), visit);
  EXPECT_EQ(x, (std::vector<double>{0.0, 2.5}));
  EXPECT_EQ(stamps, (std::vector<double>{0.0, 7.5}));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(reader.read(bytes.data(), size, visit), std::invalid_argument) << size;
  }
}

/// The relevant parts of rtabmap_msgs/MapData, with some others between them.
const char* const kMapData = R"(std_msgs/Header header
MapGraph graph
Node[] nodes
================================================================================
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
================================================================================
MSG: rtabmap_msgs/MapGraph
Header header
geometry_msgs/Transform mapToOdom
int32[] posesId
geometry_msgs/Pose[] poses
================================================================================
MSG: rtabmap_msgs/Node
int32 id
float64 stamp
string label
geometry_msgs/Pose pose # odometry's
uint8[] image
================================================================================
MSG: geometry_msgs/Transform
geometry_msgs/Vector3 translation
geometry_msgs/Quaternion rotation
================================================================================
MSG: geometry_msgs/Vector3
float64 x
float64 y
float64 z
================================================================================
MSG: geometry_msgs/Quaternion
float64 x
float64 y
float64 z
float64 w
================================================================================
MSG: geometry_msgs/Pose
Point position
Quaternion orientation
================================================================================
MSG: geometry_msgs/Point
float64 x
float64 y
float64 z
)";

TEST(RtabmapGraph, JoinsPosesWithTheStampsOfNodes) {
  std::vector<geometry_msgs::Pose> poses(3);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    poses[i].position.x = static_cast<double>(i);
    poses[i].orientation.w = 1.0;
  }
  const std::vector<std::int32_t> ids{4, 2, 9};  // 9: its node has not come yet
  const auto message =
      joined(std_msgs::Header(), std_msgs::Header(), geometry_msgs::Transform(), ids, poses,
             std::uint32_t{2}, std::int32_t{2}, 100.5, std::string("a"), poses[1],
             std::vector<std::uint8_t>(1000), std::int32_t{4}, 101.5, std::string(), poses[0],
             std::vector<std::uint8_t>(7));
  RtabmapGraph graph;
  graph.take(kMapData, message.data(), message.size());
  const std::vector<StampedPose> trajectory = graph.trajectory();
  ASSERT_EQ(trajectory.size(), 2u);
  EXPECT_EQ(trajectory[0].stamp, from_seconds(100.5));
  EXPECT_DOUBLE_EQ(trajectory[0].T_map_base.translation().x(), 1.0);
  EXPECT_DOUBLE_EQ(trajectory[1].T_map_base.translation().x(), 0.0);
  const auto path = bytes_of(nav_msgs::Path());
  EXPECT_THROW(
      graph.take(ros::message_traits::definition<nav_msgs::Path>(), path.data(), path.size()),
      std::invalid_argument);
  EXPECT_EQ(graph.trajectory().size(), 2u);
}

TEST(RtabmapPath, WithOneStampForAllIsRefusedWithTheReason) {
  std::vector<StampedPose> poses(3);
  for (StampedPose& pose : poses) pose.stamp = std::chrono::seconds(5);
  try {
    trajectory_of(path_message(poses, "map", poses[0].stamp), "map");
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("all poses carry one stamp"));
    EXPECT_THAT(error.what(), HasSubstr("mapData"));
  }
}

TEST(TfHistory, KeepsThePosesAtWhichTheLocalisationSpoke) {
  tf2::BufferCore tf;
  TfHistory history({});
  const auto drive_to = [&](double x, double stamp_s) {
    tf2_msgs::TFMessage message;
    message.transforms.resize(1);
    geometry_msgs::TransformStamped& transform = message.transforms[0];
    transform.header.frame_id = "odom_combined", transform.child_frame_id = "base_footprint";
    transform.header.stamp = ros::Time(stamp_s);
    transform.transform.translation.x = x, transform.transform.rotation.w = 1.0;
    EXPECT_EQ(enter_transforms(message, false, {}, tf), 0u);
  };
  const auto at = [](double seconds) { return from_seconds(seconds); };
  drive_to(0.0, 10.0), drive_to(1.0, 11.0);
  history.take(at(10.0), Pose::Identity());
  history.take(at(10.5), Pose::Identity());  // nothing new
  history.take(at(10.5), planar_pose(0.1, 0.0, 0.0));
  history.take(at(12.0), planar_pose(0.3, 0.0, 0.0));  // in the future: odometry is not there yet
  history.look_up(tf);
  ASSERT_EQ(history.trajectory().size(), 2u);
  EXPECT_NEAR(history.trajectory()[1].T_map_base.translation().x(), 0.6, 1e-9);
  drive_to(2.0, 12.0);
  history.look_up(tf);
  ASSERT_EQ(history.trajectory().size(), 3u);
  EXPECT_NEAR(history.trajectory()[2].T_map_base.translation().x(), 2.3, 1e-9);
}

TEST(ClockFault, NamesWhatIsSetWrongly) {
  const ros::Time now(1.7e9), bag(1.3e9), simulated(600.0);
  EXPECT_FALSE(clock_fault(false, now, now).has_value());
  EXPECT_FALSE(clock_fault(true, bag, bag).has_value());
  EXPECT_THAT(*clock_fault(false, now, bag), HasSubstr("--clock"));
  EXPECT_THAT(*clock_fault(false, now, bag), HasSubstr("days before the clock"));
  EXPECT_THAT(*clock_fault(true, ros::Time(), bag), HasSubstr("nobody publishes /clock"));
  EXPECT_THAT(*clock_fault(true, simulated, now), HasSubstr("driver stamps by another clock"));
}

TEST(Frames, AreReadFromAList) {
  EXPECT_EQ(frames_from(""), std::set<std::string>{});
  EXPECT_EQ(frames_from(" /map, odom_combined "), (std::set<std::string>{"map", "odom_combined"}));
}

TEST(OnTimeJump, HasThreeNames) {
  EXPECT_EQ(on_time_jump_from("continue"), OnTimeJump::go_on);
  EXPECT_THROW(on_time_jump_from("maybe"), std::invalid_argument);
}

}  // namespace
}  // namespace ribbon_mapper
