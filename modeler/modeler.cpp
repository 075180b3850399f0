// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/modeler.hpp"

#include "modeler/map/evidence.hpp"
#include "modeler/map/plane_builder.hpp"
#include "modeler/map/plane_map.hpp"
#include "modeler/map/trajectory.hpp"
#include "modeler/ribbon/ribbon_extraction.hpp"
#include "modeler/scan/line_buffer.hpp"

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
        extraction(config.scan, config.ribbon),
        trajectory(config.correction),
        map(config.map, config.map.slam) {}

  Evidence evidence() const { return {ribbons, strays, trajectory.poses()}; }

  ModelerConfig config;
  LineBuffer buffer;
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
    if (line.stamp <= newest->stamp) return LineResult::out_of_order;
    const double least_m = s.config.scan.base_line_sigmas * s.config.scan.range_sigma_m;
    if (base_line_m(*newest, line) < least_m) return LineResult::too_close;
  }
  s.buffer.push();
  if (!s.buffer.is_full()) return LineResult::modelled;

  const ScanLine& middle = s.buffer.middle();
  const std::vector<Ribbon>& ribbons = s.extraction.extract(s.buffer);
  s.trajectory.add({middle.stamp, middle.T_map_base});
  const auto pose = static_cast<std::uint32_t>(s.trajectory.poses().size() - 1);
  s.strays.push_back(s.extraction.strays(s.buffer));
  s.strays.back().pose = pose;
  for (Ribbon ribbon : ribbons) {
    ribbon.pose = pose;
    s.ribbons.push_back(std::move(ribbon));
    s.map.add(s.evidence().ribbon(s.ribbons.size() - 1),
              static_cast<std::uint32_t>(s.ribbons.size() - 1));
  }
  return LineResult::modelled;
}

void Modeler::correct(const std::vector<StampedPose>& corrected_trajectory) {
  State& s = *state_;
  s.trajectory.correct(corrected_trajectory);
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
