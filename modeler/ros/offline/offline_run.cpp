// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/ros/offline/offline_run.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "modeler/assembly/model_quality.hpp"
#include "modeler/exports/exports.hpp"
#include "modeler/io/config_file.hpp"
#include "modeler/io/planes_json.hpp"
#include "modeler/io/save.hpp"
#include "modeler/io/tum.hpp"
#include "modeler/map_files/map_files.hpp"
#include "modeler/model_file/model_file.hpp"
#include "modeler/observations/observations.hpp"
#include "modeler/program/figure.hpp"
#include "modeler/program/installed_files.hpp"
#include "modeler/ros/bag_check/number_text.hpp"
#include "modeler/ros/bag_check/tf_survey.hpp"
#include "modeler/ros/intake/model_doubts.hpp"
#include "modeler/ros/node/model_keeper.hpp"
#include "modeler/ros/node/turn_check.hpp"
#include "modeler/ros/offline/base_scans.hpp"
#include "modeler/ros/offline/offline_page.hpp"
#include "modeler/ros/offline/trajectory_notes.hpp"
#include "modeler/storage/file_set.hpp"
#include "modeler/surface/outline.hpp"
#include "slam/tilting/trajectory_estimate.hpp"

namespace ribbon_mapper {
namespace {

/// Says which lines never came into the recording, and whether their times can be right.
void add_doubts_about_lines(const LineLog& log, OfflineSummary& summary) {
  const std::string doubt = log.timing_doubt();
  if (!doubt.empty()) summary.notes.push_back(doubt);
  summary.lost_lines = log.lost();
  if (log.lost() > 0) {
    summary.notes.push_back(counted(log.lost(), "line") +
                            " were lost before they were recorded: header.seq has gaps");
  }
  if (log.gaps() > 0) {
    summary.notes.push_back(counted(log.gaps(), "gap") + " between lines, " +
                            number(log.silent_s(), 1) + " s in all: the laser was silent");
  }
}

/// The model of a recording, and what is learnt beside it.
struct Modelling {
  Modelling(const ModelerConfig& config, const OfflineOptions& options) : keeper(config) {
    if (!options.estimates_trajectory()) return;
    if (!options.base_scan.empty())
      base_scans.emplace(options.bags, options.bag, options.base_scan);
    estimate.emplace(keeper.modeler().observations(), slam::estimate_settings(config),
                     base_scans ? &base_scans->odometry() : nullptr);
  }
  void add(const ReadyLine& line) {
    if (base_scans) base_scans->take_until(middle_of(line.beams));
    keeper.add(line);
    turns.add(line.beams.stamp, line.poses.T_odom_base_first);
    if (estimate) estimate->update();
  }

  ModelKeeper keeper;
  TurnCheck turns;
  std::optional<BaseScans> base_scans;
  std::optional<slam::TrajectoryEstimate> estimate;
};

void take_lines(const OfflineOptions& options, Modelling& modelling, OfflineSummary& summary,
                const ProgressCallback& progress) {
  if (options.bags.empty()) return;
  ModelKeeper& keeper = modelling.keeper;
  BagLines lines(options.bags, options.bag, keeper.log());
  summary.scan_topic = lines.scan_topic();
  Time first{0};
  while (const std::optional<ReadyLine> line = lines.next()) {
    modelling.add(*line);
    if (first == Time(0)) first = line->beams.stamp;
    summary.recording_s = to_seconds(line->beams.stamp - first);
    progress({keeper.log().lines(), lines.line_count(), keeper.modeler().statistics().ribbons,
              summary.recording_s, keeper.log().busy_s()});
  }
  const TransformLog& transforms = lines.transforms();
  summary.repeated_transforms = transforms.counts().repeated;
  summary.refused_transforms = transforms.counts().refused;
  for (const std::string& choice : lines.choices()) summary.notes.push_back(choice);
  for (const std::string& warning : transform_warnings(transforms))
    summary.notes.push_back(warning);
  add_doubts_about_lines(keeper.log(), summary);
}

/// Refuses an empty model, and recordings that added nothing to a loaded one.
void require_ribbons(const ModelKeeper& keeper, const OfflineOptions& options,
                     const OfflineSummary& summary) {
  const LineLog& log = keeper.log();
  const bool is_added = log.handled_by_outcome().count(to_string(LineResult::modelled)) > 0;
  const bool is_empty = keeper.modeler().statistics().ribbons == 0;
  if (!is_empty && (is_added || options.bags.empty())) return;
  std::string why = is_empty
                        ? "no line could be modelled of " + std::to_string(log.lines()) + ": " +
                              why_no_ribbons(log)
                        : "the bags add nothing to the model that was loaded: leave them out, or "
                          "give later ones. Of " +
                              std::to_string(log.lines()) + " lines:";
  for (const auto& [reason, count] : log.dropped_by_reason()) {
    why += "\n  " + std::to_string(count) + " x " + reason;
  }
  for (const auto& [outcome, count] : log.handled_by_outcome()) {
    why += "\n  " + std::to_string(count) + " x " + outcome;
  }
  if (!log.newest_drop().empty()) why += "\nthe last one: " + log.newest_drop();
  for (const std::string& note : summary.notes) why += "\n" + note;
  throw std::runtime_error(why + "\n`bag_check` lists topics, frames and clocks of the bag");
}

/// Ends an estimate. Returns it in map, from the first recorded pose on, and keeps its covariances.
std::vector<StampedPose> finished(Modelling& modelling, OfflineRun& run) {
  slam::TrajectoryEstimate& estimate = *modelling.estimate;
  const Modeler& modeler = modelling.keeper.modeler();
  estimate.finish();
  run.summary.trajectory =
      "estimated from odometry" + std::string(modelling.base_scans ? ", a level laser" : "") +
      " and planes" + "; odometry " + number(estimate.noise_scale(), 1) + " x gmapping's noise";
  std::vector<StampedPose> poses = estimate.trajectory();
  const Pose T_map_estimate =
      modeler.trajectory().front().T_map_base * poses.front().T_map_base.inverse(Eigen::Isometry);
  for (StampedPose& pose : poses) pose.T_map_base = T_map_estimate * pose.T_map_base;
  for (const Matrix6& covariance : estimate.covariances()) {
    run.covariances.push_back(in_other_axes(covariance, T_map_estimate.linear()));
  }
  EstimateFigures& figures = run.summary.estimate.emplace();
  figures.precision = precision_of(run.covariances);
  figures.noise_scale = estimate.noise_scale();
  if (modelling.base_scans) figures.base_scans = modelling.base_scans->figures();
  figures.decisions = slam::texts_of(estimate.decisions(), poses.front().stamp);
  return poses;
}

/// Returns the final poses, or nothing if the recorded ones are only those of a SLAM on the way.
/// `given` are those of options.trajectory. Writes to the run where they are from.
std::vector<StampedPose> final_poses(const OfflineOptions& options,
                                     const std::vector<StampedPose>& given, Modelling& modelling,
                                     OfflineRun& run) {
  const Modeler& modeler = modelling.keeper.modeler();
  std::string& origin = run.summary.trajectory;
  if (modelling.estimate) return finished(modelling, run);
  if (!options.trajectory.empty()) {
    origin = options.trajectory.filename().string();
    if (auto text = lacking_time(modeler.trajectory(), given)) run.summary.notes.push_back(*text);
    return given;
  }
  if (!options.poses_are_final && modeler.statistics().revision > 0) {
    origin = "as corrected in the model that was loaded";
    if (!options.bags.empty()) origin += "; of new lines: recorded";
    return {};
  }
  const bool still = stands_still(modeler.trajectory());
  origin = still                     ? "recorded, the base stands still"
           : options.poses_are_final ? "recorded, final"
                                     : "recorded, not corrected";
  if (still || options.poses_are_final) return modeler.trajectory();
  return {};
}

ModelMaps maps_of(ModelKeeper& keeper, const MapsConfig& config) {
  const PlaneModel& model = keeper.plane_model();
  const PosedObservations observations = keeper.modeler().observations().posed();
  const Eigen::Vector3d origin = origin_of(model.planes);
  return make_maps(model.planes, sight_lines_of(observations, model, config, origin), config);
}

void describe(const ModelKeeper& keeper, const ModelerConfig& config, OfflineRun& run) {
  OfflineSummary& s = run.summary;
  s.lines = keeper.log().lines();
  s.dropped_lines = keeper.log().dropped_by_reason();
  s.newest_drop = keeper.log().newest_drop();
  s.handled_lines = keeper.log().handled_by_outcome();
  s.ribbons = keeper.modeler().statistics().ribbons;
  s.planes_before = run.planes_before.size();
  s.planes = run.planes_after.size();
  DuplicateRule rule;
  rule.touching_m = config.surface.stripe_gap_m;
  s.duplicates = duplicates_of_larger(run.planes_after, rule).size();
  s.points = point_count(run.planes_after);
  s.residual_m_median = median_residual_m(run.planes_after);
  const ModelStatistics statistics = keeper.modeler().statistics();
  if (statistics.no_return) s.notes.push_back(no_return_text(*statistics.no_return));
  if (10 * s.duplicates > s.planes) {
    s.notes.push_back("of " + counted(s.planes, "plane") + ", " + std::to_string(s.duplicates) +
                      " may stand twice: bag_check looks for the cause");
  }
  if (run.planes_after.empty()) {
    s.notes.push_back("no plane: " + why_no_planes(keeper.log(), statistics, config.assembly));
  }
}

/// What a run begins with.
struct Beginning {
  std::optional<ModelFile> file;
  ModelerConfig config;
  std::vector<StampedPose> trajectory;  // of the file that is named
};

/// Reads the model file, the preset and the trajectory, if there are, and writes to the summary
/// what they are: before the lines are modelled, which may take minutes.
Beginning begin(const OfflineOptions& options, OfflineSummary& summary) {
  Beginning result;
  if (!options.trajectory.empty() && !options.estimates_trajectory()) {
    result.trajectory = read_tum(options.trajectory);
  }
  if (!options.load.empty()) result.file = load_model_file(options.load);
  if (result.file && options.config.empty()) {
    result.config = result.file->config;
    summary.config = "of " + options.load.filename().string();
  } else {
    const auto preset = find_installed_file(options.config.empty() ? kPreset : options.config);
    result.config = load_config(preset.string());
    summary.config = portable_name(preset).string();
  }
  if (result.file) {
    summary.notes = differences(*result.file, result.config, options.bag.intake.frames.map);
  }
  return result;
}

}  // namespace

OfflineRun model_bags(const OfflineOptions& options, const ProgressCallback& progress) {
  OfflineRun run;
  for (const auto& bag : options.bags) run.summary.bags.push_back(bag.filename().string());
  Beginning beginning = begin(options, run.summary);
  const ModelerConfig& config = beginning.config;
  Modelling modelling(config, options);
  ModelKeeper& keeper = modelling.keeper;
  if (beginning.file) keeper.load(std::move(*beginning.file));
  take_lines(options, modelling, run.summary, progress);
  require_ribbons(keeper, options, run.summary);

  run.planes_before = with_outlines(keeper.modeler().planes_as_built(), config.surface);
  run.trajectory_before = keeper.modeler().trajectory();
  const auto poses = final_poses(options, beginning.trajectory, modelling, run);
  if (!poses.empty()) {
    keeper.correct(poses);
    run.summary.moved_m = largest_move_m(run.trajectory_before, keeper.modeler().trajectory());
  }
  if (const auto text = modelling.turns.contradiction(poses)) run.summary.notes.push_back(*text);
  run.planes_after = keeper.planes();
  run.labels = keeper.labels();
  run.rooms = keeper.rooms();
  run.floor_plan = keeper.floor_plan();
  run.stripe_gap_m = config.surface.stripe_gap_m;
  run.frame = options.bag.intake.frames.map;
  run.summary.parameters = changed_keys(config);
  run.trajectory = keeper.modeler().trajectory();
  run.model_file = keeper.file_bytes(run.frame);
  if (options.with_maps) run.maps = maps_of(keeper, config.maps);
  describe(keeper, config, run);
  return run;
}

void write_model(const OfflineRun& run, const std::filesystem::path& directory,
                 const OfflineExtras& extras) {
  ModelLabel label;
  label.frame = run.frame;
  label.run = run_id_of({planes_to_json(run.planes_before, label),
                         planes_to_json(run.planes_after, label), to_tum(run.trajectory)});
  FileSet files(directory, kResultsSet);
  files.add("planes_before.json", planes_to_json(run.planes_before, label));
  files.add("trajectory.tum", to_tum(run.trajectory, label.run));
  if (!run.covariances.empty()) {
    files.add(kCovarianceFile, to_covariance_csv(run.trajectory, run.covariances, label.run));
  }
  files.add(std::string("model") + kModelFileEnding, run.model_file);
  files.add("summary.json", summary_to_json(run.summary, label.run));
  files.add("report.html", offline_page(run, label.run));
  files.add("rooms.json", rooms_to_json(run.rooms, label));
  add_model(run.planes_after, label, "planes_after", run.stripe_gap_m, files, run.labels);
  add_meshes(run.planes_after, label, run.labels, extras.mesh_formats, "planes_after", files);
  add_floor_plan(run.floor_plan, label, "floor_plan", files);
  if (run.maps) add_maps(*run.maps, label, "map", files);
  if (extras.with_figure) draw_figure(Figure::model_views, files.folder(), directory);
  if (extras.with_floor_plan) draw_floor_plan(files.folder(), directory);
  files.commit();
}

}  // namespace ribbon_mapper
