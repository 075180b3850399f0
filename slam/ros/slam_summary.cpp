// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/ros/slam_summary.hpp"

#include <iomanip>
#include <locale>
#include <sstream>

#include "modeler/program/version.hpp"
#include "modeler/text/ordered_json.hpp"

namespace ribbon_mapper::slam {
namespace {

double real_time_factor(const SlamSummary& summary) {
  return summary.wall_s > 0.0 ? summary.recording_s / summary.wall_s : 0.0;
}

Json counts(const std::map<std::string, std::size_t>& by_name) {
  return by_name.empty() ? Json(Json::object()) : Json(by_name);
}

}  // namespace

std::string summary_to_json(const SlamSummary& s, const std::string& run_id) {
  const Json json{{"run", run_id},
                  {"bags", s.bags},
                  {"scan_topic", s.scan_topic},
                  {"odom_frame", s.odom_frame},
                  {"base_frame", s.base_frame},
                  {"notes", s.notes},
                  {"scans", s.scans},
                  {"dropped_scans", counts(s.dropped_scans)},
                  {"poses", s.poses},
                  {"keyframes", s.keyframes},
                  {"way_m", s.way_m},
                  {"tracking_searches", s.tracking_searches},
                  {"odometry_noise_xy", s.odometry_noise_xy},
                  {"odometry_noise_yaw", s.odometry_noise_yaw},
                  {"loop_candidates", s.loop_candidates},
                  {"loops", counts(s.loops)},
                  {"recording_s", s.recording_s},
                  {"real_time_factor", real_time_factor(s)},
                  {"loop_candidate_ms", s.loop_candidate_ms},
                  {"wall_s", s.wall_s},
                  {"cpu_s", s.cpu_s},
                  {"peak_memory_mib", s.peak_memory_mib},
                  {"version", version()}};
  return json.dump(2) + "\n";
}

std::string loops_to_json(const LevelSlamResult& result, const std::string& run_id) {
  Json loops = Json::array();
  for (const Loop& loop : result.loops) {
    loops.push_back({{"from", to_seconds(result.keyframe_stamps[loop.from])},
                     {"to", to_seconds(result.keyframe_stamps[loop.to])},
                     {"x", loop.T_from_to.x_m},
                     {"y", loop.T_from_to.y_m},
                     {"yaw", loop.T_from_to.yaw_rad},
                     {"score", loop.score},
                     {"second_score", loop.second_score},
                     {"agreeing", loop.agreeing},
                     {"way_m", loop.way_m},
                     {"accepted", loop.verdict == LoopVerdict::accepted},
                     {"reason", text_of(loop.verdict)}});
  }
  return Json{{"run", run_id}, {"loops", loops}}.dump(1) + "\n";
}

std::string summary_text(const SlamSummary& s) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed << std::setprecision(1);
  for (const std::string& note : s.notes) text << "WARNING " << note << "\n";
  text << s.scans << " scans, " << s.poses << " poses, " << s.keyframes << " keyframes, " << s.way_m
       << " m\n";
  for (const auto& [reason, count] : s.dropped_scans)
    text << "  dropped: " << count << " x " << reason << "\n";
  text << s.loop_candidates << " places searched for loops\n";
  for (const auto& [verdict, count] : s.loops) text << "  " << count << " x " << verdict << "\n";
  text << s.recording_s << " s of recording in " << std::setprecision(2) << s.wall_s << " s ("
       << std::setprecision(0) << real_time_factor(s) << " x real time, " << std::setprecision(2)
       << s.cpu_s << " s CPU), peak memory " << std::setprecision(0) << s.peak_memory_mib
       << " MiB\n";
  return text.str();
}

}  // namespace ribbon_mapper::slam
