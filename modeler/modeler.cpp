// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/modeler.hpp"

#include <cmath>

#include "modeler/map/evidence.hpp"
#include "modeler/map/plane_builder.hpp"
#include "modeler/map/plane_map.hpp"
#include "modeler/map/registration.hpp"
#include "modeler/map/trajectory.hpp"
#include "modeler/ribbon/ribbon_extraction.hpp"
#include "modeler/scan/line_buffer.hpp"
#include "modeler/scan/line_pool.hpp"

namespace ribbon_mapper {
namespace {

const ModelerConfig& validated(const ModelerConfig& config) {
  config.validate();
  return config;
}

}  // namespace

struct Modeler::State {
  explicit State(const ModelerConfig& config_)
      : config(validated(config_)),
        buffer(config.scan.base_line_sigmas * config.scan.range_sigma_m),
        pool(config.scan),
        extraction(config.scan, config.ribbon),
        trajectory(config.correction),
        map(config.map, config.map.slam) {}

  /// True if the incoming line, or the mean of it and the lines before it, has left the newest one.
  bool moved_on(const ScanLine& newest, ScanLine& line, const LaserBeams& beams,
                const LinePoses& poses) {
    const double step_m = config.scan.line_step_sigmas * config.scan.range_sigma_m;
    if (base_line_m(newest, line) >= step_m) return true;
    pool.add(beams, poses);
    if (pool.lines() < LinePool::kLeastLines) return false;
    place_beams(pool.beams(), pool.poses(), config.scan, line);
    line.pooled_lines = pool.lines();
    return base_line_m(newest, line) >= step_m / std::sqrt(static_cast<double>(pool.lines()));
  }

  /// Surfels, ribbons, association.
  void model_middle_line() {
    const ScanLine& middle = buffer.middle();
    const std::vector<Ribbon>& found = extraction.extract(buffer);
    trajectory.add({{middle.stamp, middle.T_map_base}, middle.T_odom_base});
    const auto pose = static_cast<std::uint32_t>(trajectory.poses().size() - 1);
    strays.push_back(extraction.strays(buffer));
    strays.back().pose = pose;
    for (Ribbon ribbon : found) {
      ribbon.pose = pose;
      ribbons.push_back(std::move(ribbon));
      const auto index = static_cast<std::uint32_t>(ribbons.size() - 1);
      map.add(evidence().ribbon(index), index);
    }
  }

  /// Where corrected poses are too far apart for the odometry to be believed in between.
  void register_lines() {
    std::vector<StampedPose> registered = registered_poses(
        {ribbons, trajectory.recorded(), trajectory.corrected(), trajectory.poses()}, config.map,
        config.scan.range_sigma_m);
    if (!registered.empty()) trajectory.refine(std::move(registered));
  }

  Evidence evidence() const { return {ribbons, strays, trajectory.poses()}; }

  ModelerConfig config;
  LineBuffer buffer;
  LinePool pool;
  RibbonExtraction extraction;
  std::vector<Ribbon> ribbons;
  std::vector<StrayPoints> strays;
  Trajectory trajectory;
  PlaneMap map;
  std::size_t lines = 0, revision = 0;
};

const char* to_string(LineResult result) {
  switch (result) {
    case LineResult::modelled: return "modelled";
    case LineResult::too_close: return "too close";
    case LineResult::no_returns: return "no returns";
    case LineResult::malformed: return "malformed";
    case LineResult::out_of_order: return "out of order";
  }
  return "unknown";
}

Modeler::Modeler(const ModelerConfig& config) : state_(std::make_unique<State>(config)) {}
Modeler::~Modeler() = default;
Modeler::Modeler(Modeler&&) noexcept = default;
Modeler& Modeler::operator=(Modeler&&) noexcept = default;

LineResult Modeler::add_scan_line(const LaserBeams& beams, const LinePoses& poses) {
  State& s = *state_;
  ++s.lines;
  if (defect_of(beams, poses)) return LineResult::malformed;

  ScanLine& line = s.buffer.incoming();
  place_beams(beams, poses, s.config.scan, line);
  if (line.moments(0, line.size()).weight() == 0.0) return LineResult::no_returns;
  if (const ScanLine* newest = s.buffer.newest_line()) {
    const Time last = s.pool.lines() > 0 ? s.pool.last_stamp() : newest->stamp;
    if (line.stamp <= last) return LineResult::out_of_order;
    if (!s.moved_on(*newest, line, beams, poses)) return LineResult::too_close;
  }
  s.pool.clear();
  s.buffer.push();
  while (s.buffer.advance()) s.model_middle_line();
  return LineResult::modelled;
}

void Modeler::correct(const std::vector<StampedPose>& corrected_trajectory) {
  State& s = *state_;
  s.trajectory.correct(corrected_trajectory);
  s.register_lines();
  PlaneMap again(s.config.map, s.config.map.corrected, s.map.next_id());
  for (std::uint32_t i = 0; i < s.ribbons.size(); ++i) again.add(s.evidence().ribbon(i), i);
  again.take_ids_from(s.map);
  s.map = std::move(again);
  ++s.revision;
}

void Modeler::reset() { state_ = std::make_unique<State>(state_->config); }

std::vector<Plane> Modeler::planes() const {
  return confirmed_planes(state_->map.hypotheses(), state_->evidence(), state_->config.map);
}

std::vector<Plane> Modeler::merged_planes() const {
  const State& s = *state_;
  return filtered_planes(s.map.merged_hypotheses(), s.map.gates(), s.evidence(), s.config.map);
}

const std::vector<StampedPose>& Modeler::trajectory() const { return state_->trajectory.poses(); }

const std::vector<Ribbon>& Modeler::ribbons() const { return state_->ribbons; }

ModelStatistics Modeler::statistics() const {
  return {state_->lines, state_->ribbons.size(), state_->revision};
}

std::size_t Modeler::memory_bytes() const {
  const State& s = *state_;
  std::size_t bytes = s.ribbons.capacity() * sizeof(Ribbon) + s.map.memory_bytes() +
                      2 * s.trajectory.poses().capacity() * sizeof(StampedPose);
  for (const Ribbon& ribbon : s.ribbons) {
    bytes += ribbon.samples.capacity() * sizeof(RibbonSample);
  }
  for (const StrayPoints& strays : s.strays) {
    bytes += sizeof(strays) + strays.samples.capacity() * sizeof(RibbonSample);
  }
  return bytes;
}

}  // namespace ribbon_mapper
