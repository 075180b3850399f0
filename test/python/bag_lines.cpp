// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes the lines of a bag with their poses, as offline_modeler reads them: bag_lines BAG FILE.
#include "modeler/ros/bag/bag_lines.hpp"

#include <ros/time.h>

#include <cstdio>

#include "test/python/lines_file.hpp"

using namespace ribbon_mapper;

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: bag_lines BAG FILE\n");
    return 2;
  }
  ros::Time::init();
  LineLog log;
  BagLines lines({argv[1]}, BagOptions{}, log);
  LinesFile file(argv[2]);
  while (const std::optional<ReadyLine> line = lines.next()) file.add(line->beams, line->poses);
  return 0;
}
