// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/modeler.hpp"

#include <cmath>

#include "modeler/assembly/plane_assembly.hpp"
#include "modeler/association/plane_map.hpp"
#include "modeler/geometry/vector_storage.hpp"
#include "modeler/observations/observations.hpp"
#include "modeler/observations/thinning.hpp"
#include "modeler/registration/registration.hpp"
#include "modeler/ribbon/ribbon_extraction.hpp"
#include "modeler/scan/line_averaging.hpp"
#include "modeler/scan/line_buffer.hpp"
#include "modeler/trajectory/trajectory.hpp"

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
    if (pool.lines() < LineAverager::kMinLines) return false;
    place_beams(pool.beams(), pool.poses(), config.scan, line);
    line.averaged_lines = pool.lines();
    return base_line_m(newest, line) >= step_m / std::sqrt(static_cast<double>(pool.lines()));
  }

  /// Surfels, ribbons, association.
  void model_middle_line() {
    const ScanLine& middle = buffer.middle();
    const std::vector<Ribbon>& found = extraction.extract(buffer, points);
    trajectory.add({{middle.stamp, middle.T_map_base}, middle.T_odom_base});
    const auto pose = static_cast<std::uint32_t>(trajectory.size() - 1);
    const Pose T_model_base =
        trajectory.T_map_base(0).inverse(Eigen::Isometry) * trajectory.T_map_base(pose);
    reserve_one_more(unassigned);
    unassigned.push_back(extraction.unassigned(buffer, points));
    unassigned.back().pose = pose;
    for (Ribbon ribbon : found) {
      ribbon.pose = pose;
      reserve_one_more(ribbons);
      ribbons.push_back(ribbon);
      map.add({ribbon, T_model_base}, static_cast<std::uint32_t>(ribbons.size() - 1));
    }
    if (max_ribbons() > 0 && ribbons.size() > max_ribbons()) thin();
  }

  /// Where corrected poses are too far apart for the odometry to be believed in between.
  void register_lines() {
    const SharedSettings shared{config.scan.range_sigma_m, config.map.corrected,
                                config.map.bridged_gap_m};
    const std::vector<StampedPose> registered =
        registered_poses(ribbons, trajectory, config.registration, shared);
    if (!registered.empty()) trajectory.refine(registered);
  }

  /// Leaves ribbons out where they are dense, and lines that none of the others came from.
  void thin() {
    const std::size_t count = max_ribbons() - max_ribbons() / 8;
    const std::vector<std::uint32_t> kept = thinned(observations(), count);
    thinned_ribbons += ribbons.size() - kept.size();
    keep_indices(kept, ribbons);
    std::vector<std::uint32_t> kept_poses;
    for (Ribbon& ribbon : ribbons) {
      if (kept_poses.empty() || kept_poses.back() != ribbon.pose) kept_poses.push_back(ribbon.pose);
      ribbon.pose = static_cast<std::uint32_t>(kept_poses.size() - 1);
    }
    trajectory.keep(kept_poses);
    keep_indices(kept_poses, unassigned);
    for (std::uint32_t i = 0; i < unassigned.size(); ++i) unassigned[i].pose = i;
    store_anew();
    evaluate_anew(map.gates(), kept);
  }

  /// Gives back the room of samples and points that are no longer in use.
  void store_anew() {
    PointStore anew;
    for (Ribbon& ribbon : ribbons) {
      ribbon.samples.first = anew.samples.keep(ribbon.samples.first, ribbon.samples.size);
    }
    for (UnassignedPoints& line : unassigned)
      line.first = anew.unassigned.keep(line.first, line.size);
    points = std::move(anew);
  }

  /// All ribbons at the poses of now. `index_before`: see PlaneMap::take_ids_from().
  void evaluate_anew(const AssociationGates& gates,
                     const std::vector<std::uint32_t>& index_before = {}) {
    PlaneMap anew(config.map, gates, map.next_id());
    const Observations all = observations();
    for (std::uint32_t i = 0; i < ribbons.size(); ++i) anew.add(all.ribbon(i), i);
    anew.take_ids_from(map, index_before);
    map = std::move(anew);
  }

  std::size_t max_ribbons() const { return static_cast<std::size_t>(config.map.max_ribbons); }

  Observations observations() const { return {ribbons, unassigned, trajectory.poses()}; }

  ModelerConfig config;
  LineBuffer buffer;
  LineAverager pool;
  RibbonExtraction extraction;
  PointStore points;  ///< of ribbons and unassigned
  std::vector<Ribbon> ribbons;
  std::vector<UnassignedPoints> unassigned;
  Trajectory trajectory;
  PlaneMap map;
  std::size_t lines = 0, revision = 0, thinned_ribbons = 0;
};

const char* to_string(LineResult result) {
  switch (result) {
    case LineResult::modelled:
      return "modelled";
    case LineResult::too_close:
      return "too close";
    case LineResult::no_returns:
      return "no returns";
    case LineResult::malformed:
      return "malformed";
    case LineResult::out_of_order:
      return "out of order";
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
  s.evaluate_anew(s.config.map.corrected);
  ++s.revision;
}

void Modeler::reset() { state_ = std::make_unique<State>(state_->config); }

std::vector<Plane> Modeler::planes_as_built() const {
  return confirmed_planes(state_->map.hypotheses(), state_->observations(), state_->config.map);
}

std::vector<Plane> Modeler::planes() const {
  const State& s = *state_;
  return filtered_planes(s.map.merged_hypotheses(), s.map.gates(), s.observations(), s.config.map);
}

std::vector<StampedPose> Modeler::trajectory() const { return state_->trajectory.poses(); }

const std::vector<Ribbon>& Modeler::ribbons() const { return state_->ribbons; }

ModelStatistics Modeler::statistics() const {
  return {state_->lines, state_->ribbons.size(), state_->thinned_ribbons, state_->revision};
}

std::size_t Modeler::memory_bytes() const {
  const State& s = *state_;
  return s.ribbons.capacity() * sizeof(Ribbon) +
         s.unassigned.capacity() * sizeof(UnassignedPoints) + s.points.samples.memory_bytes() +
         s.points.unassigned.memory_bytes() + s.map.memory_bytes() + s.trajectory.memory_bytes();
}

}  // namespace ribbon_mapper
