// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <ribbon_mapper/PlaneArray.h>
#include <ros/ros.h>

#include <cstdio>

#include "modeler/modeler.hpp"

namespace {

void print_planes(const ribbon_mapper::PlaneArray& message) {
  std::printf("planes of a message: %zu\n", message.planes.size());
}

}  // namespace

int main(int argc, char** argv) {
  const ribbon_mapper::Modeler modeler(ribbon_mapper::ModelerConfig{});
  std::printf("planes: %zu\n", modeler.planes().size());
  if (argc < 2) return 0;
  ros::init(argc, argv, "catkin_consumer");
  ros::NodeHandle node;
  const auto subscriber = node.subscribe("modeler/planes", 1, print_planes);
  ros::spin();
}
