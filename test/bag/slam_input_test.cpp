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

/// Returns why a definition or its message is refused; empty if neither is.
std::string complaint_about(const std::string& definition,
                            const std::vector<std::uint8_t>& message = {}) {
  try {
    WireReader(definition).read(message.data(), message.size(), [](const std::string&, double) {});
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(WireReader, RefusesTypesThatContainThemselves) {
  const char* const kWhy = "types within types without end";
  EXPECT_THAT(complaint_about("pkg/A a\n====\nMSG: pkg/A\npkg/A a\n"), HasSubstr(kWhy));
  EXPECT_THAT(complaint_about("A[] a\n====\nMSG: pkg/A\nuint8 x\nA[] a\n"), HasSubstr(kWhy));
  EXPECT_THAT(complaint_about("A a\n===\nMSG: p/A\nB[2] b\nB c\n===\nMSG: p/B\nA a\nA b\n"),
              HasSubstr(kWhy));
  std::string chain = "T0 t\n";
  for (int i = 0; i < 100'000; ++i) {
    chain += "===\nMSG: p/T" + std::to_string(i) + "\nT" + std::to_string(i + 1) + " t\n";
  }
  EXPECT_THAT(complaint_about(chain), HasSubstr(kWhy));
}

TEST(WireReader, SkipsElementsWithoutContentWhateverTheirNumber) {
  const std::string empty = "====\nMSG: p/E\n# nothing\n====\nMSG: p/N\nE e\nE[7] f\nuint8[0] g\n";
  const auto count = bytes_of(std::uint32_t{4'000'000'000u});
  for (const char* fields : {"E[] e\n", "N[] n\n"}) {
    EXPECT_EQ("", complaint_about(fields + empty, count)) << fields;
  }
  EXPECT_EQ("", complaint_about("N[4000000000] n\nE[4000000000] e\nuint8 x\n" + empty, {1}));
  double sum = 0.0;
  const auto message = joined(std::uint32_t{4'000'000'000u}, 2.5);
  WireReader("N[] n\nfloat64 x\n" + empty)
      .read(message.data(), message.size(),
            [&](const std::string&, double value) { sum += value; });
  EXPECT_EQ(sum, 2.5);
}

TEST(WireReader, RefusesCountsBeyondTheMessageAtOnce) {
  const auto count = bytes_of(std::uint32_t{4'000'000'000u});
  std::string powers = "T0[4294967295] t\n";  // 4294967295^20 bytes
  for (int i = 0; i < 20; ++i) {
    powers +=
        "===\nMSG: p/T" + std::to_string(i) + "\nT" + std::to_string(i + 1) + "[4294967295] t\n";
  }
  powers += "===\nMSG: p/T20\nuint8 x\n";
  for (const std::string& definition :
       {std::string("float64[] x\n"), std::string("string[] x\n"),
        std::string("float64[4294967295] x\n"), std::string("uint8[] x\n"),
        std::string("P[] p\n===\nMSG: p/P\nfloat64 x\n"), powers}) {
    EXPECT_THAT(complaint_about(definition, count), HasSubstr("shorter than its definition"));
  }
}

TEST(WireReader, RefusesWhatIsNoDefinition) {
  EXPECT_THAT(complaint_about(""), HasSubstr("is empty"));
  EXPECT_THAT(complaint_about("uint8"), HasSubstr("no field name"));
  EXPECT_THAT(complaint_about("uint8[ x"), HasSubstr("no ']'"));
  EXPECT_THAT(complaint_about("uint8[-1] x"), HasSubstr("array length '-1'"));
  EXPECT_THAT(complaint_about("uint8[99999999999] x"), HasSubstr("array length"));
  EXPECT_THAT(complaint_about("uint8[two] x"), HasSubstr("array length 'two'"));
  EXPECT_THAT(complaint_about("Header h"), HasSubstr("lacks the type Header"));
  EXPECT_THAT(complaint_about("[] x"), HasSubstr("lacks the type"));
  EXPECT_THAT(complaint_about("A a\n===\nMSG: p/A\nuint8 x\n===\nMSG: p/A\nuint8 x\n"),
              HasSubstr("twice"));
  EXPECT_LT(complaint_about("A" + std::string(1'000'000, 'x') + " a").size(), 400u);
}

TEST(WireReader, TellsConstantsFromComments) {
  std::vector<double> values;
  const std::vector<std::uint8_t> message{1, 2, 3};
  WireReader("uint8 A=7\nuint8 x # = 1\nstring S=a # b\nuint8 y#y=2\nuint8 z\n")
      .read(message.data(), message.size(),
            [&](const std::string&, double value) { values.push_back(value); });
  EXPECT_EQ(values, (std::vector<double>{1, 2, 3}));
}

TEST(WireReader, PrefersTypesOfThePackageThatUsesThem) {
  double value = 0.0;
  const std::vector<std::uint8_t> message{9};
  WireReader(
      "b/User u\n===\nMSG: a/Point\nfloat64 x\n===\nMSG: b/Point\nuint8 x\n===\nMSG: b/User\nPoint "
      "p\n")
      .read(message.data(), message.size(), [&](const std::string&, double x) { value = x; });
  EXPECT_EQ(value, 9.0);
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
    EXPECT_EQ(enter_transforms(message, false, {}, tf).refused, 0u);
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
