// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/ros/offline_options.hpp"

#include <CLI/CLI.hpp>

#include "modeler/ros/message_conversions.hpp"
#include "modeler/ros/transform_entry.hpp"

namespace ribbon_mapper::eval {
namespace {

constexpr const char* kDescription =
    "Models the scan lines of a bag as fast as it goes, without a ROS master: the same code as the\n"
    "node, the same bag gives the same planes, byte for byte.\n"
    "Writes planes_before.json (recorded poses, as built on the way), planes_after.{json,ply,bt} with\n"
    "planes_after_cells.ply (the final model), trajectory.tum and summary.json.";

constexpr const char* kFooter =
    "Not sure what is in the bag? `bag_check FILE` says it, and what stands in the way.\n"
    "Exit code: 0 done, 1 it could not be done, 2 wrong usage.";

}  // namespace

std::variant<OfflineOptions, int> parse_offline_options(int argc, const char* const* argv) {
  OfflineOptions options;
  std::string tf_drop_frames;
  CLI::App app(kDescription, "offline_modeler");
  app.footer(kFooter);
  app.add_option("--bag", options.bags, "bags, read as one in order of time")->required();
  app.add_option("--output", options.output, "folder for the results")->capture_default_str();
  app.add_option("--config", options.config, "preset of the modeler")->capture_default_str();
  app.add_option("--trajectory", options.trajectory,
                 "corrected poses of the base in map (TUM: stamp x y z qx qy qz qw)");
  app.add_flag("--poses-are-final", options.poses_are_final,
               "the recorded poses are as good as corrected ones; known when the base stands still")
      ->excludes("--trajectory");
  app.add_option("--scan", options.bag.scan_topic,
                 "topic of the tilting laser [the only one, or tilt_scan]");
  Frames& frames = options.bag.intake.frames;
  app.add_option("--map-frame", frames.map)->capture_default_str();
  app.add_option("--odom-frame", frames.odom)->capture_default_str();
  app.add_option("--base-frame", frames.base)->capture_default_str();
  app.add_option("--scan-time-offset", options.bag.intake.scan_time_offset_s,
                 "added to the stamps of scans [s]")
      ->check(CLI::Range(-1.0, 1.0))
      ->capture_default_str();
  app.add_option("--transform-timeout", options.bag.intake.transform_timeout_s,
                 "how much later in the bag than its scan a transform may come [s]")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
  app.add_option("--tf-drop-frames", tf_drop_frames,
                 "leave out transforms whose parent is one of these, such as \"map odom_combined\"");
  app.add_flag("--figure", options.with_figure, "draw model_views.png from above and from the side");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  for (std::string* frame : {&frames.map, &frames.odom, &frames.base}) *frame = without_slash(*frame);
  options.bag.tf_drop_frames = frames_from(tf_drop_frames);
  return options;
}

}  // namespace ribbon_mapper::eval
