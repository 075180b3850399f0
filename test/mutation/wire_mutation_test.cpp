// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <nav_msgs/Path.h>
#include <ros/message_traits.h>
#include <ros/serialization.h>

#include "modeler/ros/slam_adapter/rtabmap_graph.hpp"
#include "modeler/ros/slam_adapter/wire_reader.hpp"
#include "test/mutation/mutator.hpp"

namespace ribbon_mapper::mutation {
namespace {

const std::uint8_t* data_of(const std::string& bytes) {
  return reinterpret_cast<const std::uint8_t*>(bytes.data());
}

/// Returns the bytes of a path of a few poses.
std::string path_bytes() {
  nav_msgs::Path path;
  path.header.frame_id = "map";
  path.poses.resize(3);
  std::string bytes(ros::serialization::serializationLength(path), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, path);
  return bytes;
}

const std::vector<std::string> kWords{"[]",
                                      "[4294967295]",
                                      "[0]",
                                      "MSG: std_msgs/Header\n",
                                      "geometry_msgs/Pose[] poses\n",
                                      "====\n",
                                      "Header header\n",
                                      "string ",
                                      "uint8[] ",
                                      "=",
                                      "#",
                                      "\n",
                                      " "};

/// Reads a message by a definition, as slam_adapter does.
void read(const std::string& definition, const std::string& message) {
  std::size_t numbers = 0;
  WireReader(definition).read(data_of(message), message.size(), [&](const std::string&, double) {
    ++numbers;
  });
  EXPECT_LE(numbers, message.size());
}

TEST(DefinitionMutations, AreReadOrRefused) {
  const std::string message = path_bytes();
  const std::string definition = ros::message_traits::definition<nav_msgs::Path>();
  expect_read_or_refused(Mutator({definition}, kWords), "definition",
                         [&](const std::string& text) { read(text, message); });
}

TEST(MessageMutations, AreReadOrRefused) {
  const std::string definition = ros::message_traits::definition<nav_msgs::Path>();
  const std::vector<std::string> words{std::string(4, '\xff'), std::string(4, '\0')};
  expect_read_or_refused(Mutator({path_bytes()}, words), "message",
                         [&](const std::string& bytes) { read(definition, bytes); });
}

TEST(GraphMutations, AreReadOrRefused) {
  const std::string definition =
      "int32[] posesId\nPose[] poses\nNode[] nodes\n====\nMSG: r/Node\nint32 id\nfloat64 stamp\n"
      "====\nMSG: r/Pose\nPoint position\nQuaternion orientation\n====\nMSG: r/Point\nfloat64 x\n"
      "float64 y\nfloat64 z\n====\nMSG: r/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n";
  const std::string message = std::string("\1\0\0\0\1\0\0\0\1\0\0\0", 12) + std::string(54, '\0') +
                              "\xf0\x3f" + std::string("\1\0\0\0\1\0\0\0", 8) + std::string(8, '@');
  expect_read_or_refused(Mutator({definition}, kWords), "graph", [&](const std::string& text) {
    RtabmapGraph graph;
    graph.take(text, data_of(message), message.size());
    EXPECT_LE(graph.trajectory().size(), 1u);
  });
}

}  // namespace
}  // namespace ribbon_mapper::mutation
