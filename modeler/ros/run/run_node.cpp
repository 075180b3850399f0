// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/run/run_node.hpp"

#include <ros/ros.h>

#include <cstdio>
#include <exception>
#include <string>

#include "modeler/program/version.hpp"

namespace ribbon_mapper {
namespace {

/// Returns what a person who calls the node by hand asks for; empty if that is to run.
std::string answer(int argc, char** argv, const NodeInfo& node) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--version") return version() + "\n";
    if (argument != "-h" && argument != "--help") continue;
    std::string text = std::string(node.name) + ", a node of ROS: " + node.purpose + "\n\n";
    if (node.launch_file != nullptr) {
      const std::string launch = std::string("ribbon_mapper ") + node.launch_file;
      text += "roslaunch " + launch + "\nroslaunch --ros-args " + launch +
              "   # the arguments of the launch file\n";
    }
    return text + "rosrun ribbon_mapper " + node.name + " _PARAMETER:=VALUE TOPIC:=OTHER_TOPIC\n";
  }
  return "";
}

}  // namespace

int run_node(int argc, char** argv, const NodeInfo& node, const std::function<int()>& work) {
  const std::string text = answer(argc, argv, node);
  if (!text.empty()) {
    std::fputs(text.c_str(), stdout);
    return 0;
  }
  ros::init(argc, argv, node.name);
  const ros::NodeHandle keeps_logging_up;  // logging ends with the last handle
  try {
    return work();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
}

}  // namespace ribbon_mapper
