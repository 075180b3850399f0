// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/ros/slam_run.hpp"

#include <chrono>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>

#include "modeler/io/model_label.hpp"
#include "modeler/io/tum.hpp"
#include "modeler/program/figure.hpp"
#include "modeler/ros/bag_check/number_text.hpp"
#include "modeler/ros/bag_check/tf_survey.hpp"
#include "modeler/storage/file_set.hpp"

namespace ribbon_mapper::slam {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kPointSpacing_m = 0.05;
constexpr const char* kInclined = "the laser is not level";

/// Hands lines over to the SLAM, and measures what loops cost.
class Feeder {
 public:
  Feeder(const LevelSlamConfig& config, LineLog& log) : config_(config), slam_(config), log_(log) {}

  void add(const ReadyLine& line) {
    if (!is_level(line.poses.T_base_laser_first, config_.scan)) {
      log_.dropped(kInclined, line.frame + " is inclined in the frame of the base");
      return;
    }
    const PlanarPose first = planar(line.poses.T_odom_base_first);
    const LevelScan scan =
        level_scan_of(line.beams, line.poses.T_base_laser_first,
                      relative(first, planar(line.poses.T_odom_base_last)), config_.scan);
    const std::size_t before = slam_.loop_finder().searches();
    const Clock::time_point start = Clock::now();
    try {
      slam_.add(scan, first);
    } catch (const std::invalid_argument& error) {
      log_.dropped(error.what());
      return;
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    log_.handled("tracked", seconds);
    if (slam_.loop_finder().searches() > before) loops_s_ += seconds;
  }

  LevelSlam& slam() { return slam_; }
  double loops_s() const { return loops_s_; }

 private:
  LevelSlamConfig config_;
  LevelSlam slam_;
  LineLog& log_;
  double loops_s_ = 0.0;
};

void take_scans(const SlamOptions& options, Feeder& feeder, LineLog& log, SlamSummary& summary,
                const ProgressCallback& progress) {
  BagLines lines(options.bags, options.bag, log);
  summary.scan_topic = lines.scan_topic();
  Time first{0};
  while (const std::optional<ReadyLine> line = lines.next()) {
    feeder.add(*line);
    if (first == Time(0)) first = line->beams.stamp;
    summary.recording_s = to_seconds(line->beams.stamp - first);
    progress({log.lines(), lines.line_count(), 0, summary.recording_s, log.busy_s()});
  }
  summary.odom_frame = lines.frames().odom;
  summary.base_frame = lines.frames().base;
  summary.notes = lines.choices();
  for (const std::string& warning : transform_warnings(lines.transforms()))
    summary.notes.push_back(warning);
}

/// Refuses a recording none of whose scans was used, and one of a laser that tilts.
void require_scans(const LineLog& log, const SlamSummary& summary) {
  const std::map<std::string, std::size_t>& dropped = log.dropped_by_reason();
  const auto inclined = dropped.find(kInclined);
  const bool tilts = inclined != dropped.end() && 2 * inclined->second > log.lines();
  if (summary.poses > 0 && !tilts) return;
  std::string why =
      tilts ? "the laser tilts: offline_modeler is for it; or give --scan a level one's "
              "topic. Scans: "
            : "no scan could be used of ";
  why += std::to_string(log.lines());
  for (const auto& [reason, count] : log.dropped_by_reason())
    why += "\n  " + std::to_string(count) + " x " + reason;
  if (!log.newest_drop().empty()) why += "\nthe last one: " + log.newest_drop();
  for (const std::string& note : summary.notes) why += "\n" + note;
  throw std::runtime_error(why + "\n`bag_check` says more");
}

void describe(Feeder& feeder, const LineLog& log, SlamRun& run) {
  SlamSummary& s = run.summary;
  const LevelSlam& slam = feeder.slam();
  s.scans = log.lines();
  s.dropped_scans = log.dropped_by_reason();
  if (log.lost() > 0)
    s.notes.push_back(counted(log.lost(), "scan") + " were lost before they were recorded");
  s.keyframes = slam.tracker().keyframes().size();
  s.way_m = s.keyframes > 0 ? slam.tracker().keyframes().back().way_m : 0.0;
  s.tracking_searches = slam.tracker().searches();
  s.odometry_noise_xy = slam.tracker().noise().scale_xy();
  s.odometry_noise_yaw = slam.tracker().noise().scale_yaw();
  s.loop_candidates = slam.loop_finder().searches();
  for (const Loop& loop : run.result.loops) ++s.loops[text_of(loop.verdict)];
  if (s.loop_candidates > 0)
    s.loop_candidate_ms = 1e3 * feeder.loops_s() / static_cast<double>(s.loop_candidates);
}

std::vector<Eigen::Vector2d> map_points(const LevelSlam& slam, const LevelSlamResult& result) {
  LevelPoints all;
  for (const Keyframe& keyframe : slam.tracker().keyframes())
    append_moved(keyframe.points, result.trajectory[keyframe.scan].T_map_base, all);
  std::vector<Eigen::Vector2d> points;
  for (const LevelPoint& point : thinned(all, kPointSpacing_m))
    points.emplace_back(point.x_m, point.y_m);
  return points;
}

std::string points_text(const std::vector<Eigen::Vector2d>& points, const std::string& run) {
  std::string text = "# run " + run + "\n# x y, in map [m]\n";
  char line[64];
  for (const Eigen::Vector2d& point : points) {
    std::snprintf(line, sizeof line, "%.3f %.3f\n", point.x(), point.y());
    text += line;
  }
  return text;
}

std::vector<StampedPose> in_space(const std::vector<StampedPlanarPose>& trajectory) {
  std::vector<StampedPose> poses;
  for (const auto& [stamp, pose] : trajectory)
    poses.push_back({stamp, planar_pose(pose.x_m, pose.y_m, pose.yaw_rad)});
  return poses;
}

}  // namespace

SlamRun run_slam(const SlamOptions& options, const ProgressCallback& progress) {
  LineLog log;
  Feeder feeder({}, log);
  SlamRun run;
  for (const auto& bag : options.bags) run.summary.bags.push_back(bag.filename().string());
  take_scans(options, feeder, log, run.summary, progress);
  run.summary.poses = feeder.slam().scan_count();
  require_scans(log, run.summary);
  run.result = feeder.slam().finish();
  run.points = map_points(feeder.slam(), run.result);
  describe(feeder, log, run);
  return run;
}

void write_slam(const SlamRun& run, const std::filesystem::path& directory, bool with_figure) {
  const std::vector<StampedPose> trajectory = in_space(run.result.trajectory);
  const std::string id = run_id_of({to_tum(trajectory), loops_to_json(run.result, "")});
  FileSet files(directory, kResultsSet);
  files.add("trajectory.tum", to_tum(trajectory, id));
  files.add("loops.json", loops_to_json(run.result, id));
  files.add("map_points.txt", points_text(run.points, id));
  files.add("summary.json", summary_to_json(run.summary, id));
  if (with_figure) draw_figure(Figure::level_map, files.folder(), directory);
  files.commit();
}

}  // namespace ribbon_mapper::slam
