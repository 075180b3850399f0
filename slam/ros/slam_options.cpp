// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/ros/slam_options.hpp"

#include <CLI/CLI.hpp>

#include "modeler/program/version.hpp"
#include "modeler/ros/bag_check/bag_check_options.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr const char* kDescription =
    "Estimates the trajectory of a robot from the level laser and the odometry in a bag, without "
    "a\n"
    "ROS master. The same bag gives the same trajectory, byte for byte.\n"
    "Writes trajectory.tum (the base in map at each scan), loops.json (loops that were closed or\n"
    "refused, and why), map_points.txt and summary.json. The first pose is the origin of map.";

constexpr const char* kFooter =
    "Not sure what is in the bag? `bag_check FILE` lists it and reports what is wrong.\n"
    "Exit code: 0 success, 1 failure, 2 wrong usage.";

}  // namespace

std::variant<SlamOptions, int> parse_slam_options(int argc, const char* const* argv) {
  SlamOptions options;
  std::string tf_drop_frames;
  CLI::App app(kDescription, "offline_slam");
  app.set_version_flag("--version", version());
  app.footer(kFooter);
  app.add_option("--bag", options.bags, "bags, read as one in the order of time")->required();
  app.add_option("--output", options.output, "folder for the results")->capture_default_str();
  add_bag_options(app, options.bag, tf_drop_frames);
  app.add_option("--odometry", options.bag.odometry_topic,
                 "topic of nav_msgs/Odometry, where tf has none, such as /odom");
  app.get_option("--scan")->description("topic of the level laser [the only topic with scans]");
  app.remove_option(app.get_option("--map-frame"));
  app.add_flag("--figure", options.with_figure,
               "draw level_map.png: points and trajectory from above");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  finish_bag_options(options.bag, tf_drop_frames);
  // a localisation in the bag is not used: the map is what is estimated
  options.bag.intake.frames.map = options.bag.intake.frames.odom;
  options.bag.named_frames.map = options.bag.named_frames.odom;
  return options;
}

}  // namespace ribbon_mapper::slam
