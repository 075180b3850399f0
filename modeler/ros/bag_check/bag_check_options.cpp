// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/bag_check/bag_check_options.hpp"

#include "modeler/program/version.hpp"
#include "modeler/ros/messages/message_conversions.hpp"
#include "modeler/ros/messages/transform_entry.hpp"

namespace ribbon_mapper {
namespace {

constexpr const char* kDescription =
    "Checks whether a bag can be mapped and reports what is wrong with it: topics, stamps, gaps,\n"
    "tf, ranges, the tilt, the spacing of lines and beams, and the time offset of the laser.";

constexpr const char* kFooter =
    "Exit code: 0 it can be mapped (with or without warnings), 1 it cannot, 2 wrong usage.";

}  // namespace

void add_bag_options(CLI::App& app, BagOptions& options, std::string& tf_drop_frames) {
  app.add_option("--scan", options.scan_topic,
                 "topic of the tilting laser [the only topic with scans, or tilt_scan]");
  app.add_option("--tf-topic", options.tf_topic,
                 "topic with transforms, such as /robot1/tf [/tf, or the only one]");
  const auto add_frame = [&app](const char* name, std::string& frame, bool& is_named,
                                const std::string& what) {
    app.add_option(name, frame, what + "; if tf lacks the default, the only choice is taken")
        ->check([](const std::string& given) {
          return without_slash(given).empty() ? std::string("must not be empty") : std::string();
        })
        ->each([&is_named](const std::string&) { is_named = true; })
        ->capture_default_str();
  };
  Frames& frames = options.intake.frames;
  add_frame("--map-frame", frames.map, options.named_frames.map, "frame of the localisation");
  add_frame("--odom-frame", frames.odom, options.named_frames.odom, "frame of odometry");
  add_frame("--base-frame", frames.base, options.named_frames.base, "frame of the robot");
  app.add_option("--scan-time-offset", options.intake.scan_time_offset_s,
                 "added to the stamps of scans [s]")
      ->check(CLI::Range(-1.0, 1.0))
      ->capture_default_str();
  app.add_option("--transform-timeout", options.intake.transform_timeout_s,
                 "how far a gap in tf that poses are interpolated over may reach beyond a scan [s]")
      ->check(CLI::Range(0.0, 3600.0))
      ->capture_default_str();
  app.add_option(
      "--tf-drop-frames", tf_drop_frames,
      "leave out transforms whose parent is one of these, such as \"map odom_combined\"");
}

void finish_bag_options(BagOptions& options, const std::string& tf_drop_frames) {
  Frames& frames = options.intake.frames;
  for (std::string* frame : {&frames.map, &frames.odom, &frames.base})
    *frame = without_slash(*frame);
  options.tf_drop_frames = frames_from(tf_drop_frames);
}

std::variant<BagCheckOptions, int> parse_bag_check_options(int argc, const char* const* argv) {
  BagCheckOptions options;
  std::string tf_drop_frames;
  CLI::App app(kDescription, "bag_check");
  app.set_version_flag("--version", version());
  app.footer(kFooter);
  app.add_option("bag,--bag", options.bags, "bags, read as one in the order of time")->required();
  app.add_option("--config", options.config, "preset that the bag is judged by")
      ->capture_default_str();
  app.add_option("--propose-preset", options.proposed_preset,
                 "write a preset for this laser to a file, for --config");
  add_bag_options(app, options.bag, tf_drop_frames);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  finish_bag_options(options.bag, tf_drop_frames);
  return options;
}

}  // namespace ribbon_mapper
