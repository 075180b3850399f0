// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/offline/offline_options.hpp"

#include <CLI/CLI.hpp>

#include "modeler/exports/export_options.hpp"
#include "modeler/program/version.hpp"
#include "modeler/ros/bag_check/bag_check_options.hpp"

namespace ribbon_mapper {
namespace {

constexpr const char* kDescription =
    "Models the scan lines of a bag as fast as possible, with the code of the node but without a\n"
    "ROS master. The same bag gives the same planes, byte for byte.\n"
    "Writes planes_before.json (recorded poses, as built on the way), planes_after.{json,ply,bt}\n"
    "and planes_after_cells.ply (the final model), planes_after.glb (its mesh for other "
    "programs),\n"
    "floor_plan.geojson (walls, doors and rooms from above), report.html (a page to look at it),\n"
    "model.ribbons (to be loaded again), trajectory.tum and summary.json, with --trajectory self\n"
    "trajectory_covariance.csv as well.";

constexpr const char* kFooter =
    "Not sure what is in the bag? `bag_check FILE` lists it and reports what is wrong.\n"
    "Exit code: 0 success, 1 failure, 2 wrong usage, 130 interrupted.";

/// Throws CLI::Error if options contradict each other.
void check(const OfflineOptions& options) {
  if (!options.base_scan.empty() && !options.estimates_trajectory()) {
    throw CLI::ValidationError("--base-scan", "only the estimate uses it: add --trajectory self");
  }
  if (options.load.empty() && options.bags.empty()) throw CLI::RequiredError("--bag, or --load,");
  if (!options.load.empty() && options.estimates_trajectory()) {
    throw CLI::ExcludesError("--load", "--trajectory self");
  }
}

}  // namespace

std::variant<OfflineOptions, int> parse_offline_options(int argc, const char* const* argv) {
  OfflineOptions options;
  std::string tf_drop_frames;
  CLI::App app(kDescription, "offline_modeler");
  app.set_version_flag("--version", version());
  app.footer(kFooter);
  app.add_option("--bag", options.bags, "bags, read as one in the order of time");
  app.add_option(
         "--load", options.load,
         "model file (*.ribbons) to go on from, with its configuration if no other is named")
      ->check(CLI::ExistingFile);
  app.add_option("--output", options.output, "folder for the results")->capture_default_str();
  app.add_option("--config", options.config, "preset of the modeler")->default_str(kPreset);
  app.add_option("--trajectory", options.trajectory,
                 "corrected poses of the base in map (TUM: stamp x y z qx qy qz qw); or `self`: "
                 "estimated from odometry and planes");
  app.add_option("--base-scan", options.base_scan,
                 "topic of a level laser on the base, which refines the odometry of "
                 "--trajectory self, such as base_scan");
  app.add_flag("--poses-are-final", options.poses_are_final,
               "treat the recorded poses as corrected ones; implied if the base stands still")
      ->excludes("--trajectory");
  add_bag_options(app, options.bag, tf_drop_frames);
  app.add_flag("--figure", options.with_figure,
               "draw model_views.png: the model from above and from the side");
  app.add_flag("--maps", options.with_maps,
               "write map.pgm and map.yaml for map_server, and map.bt, an OctoMap of free and "
               "occupied space");
  add_export_options(app, options.with_floor_plan, options.mesh_formats);
  try {
    app.parse(argc, argv);
    check(options);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  finish_bag_options(options.bag, tf_drop_frames);
  return options;
}

}  // namespace ribbon_mapper
