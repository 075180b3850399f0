// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/modeler.hpp"

#include <optional>
#include <utility>

#include "modeler/assembly/plane_assembly.hpp"
#include "modeler/association/plane_map.hpp"
#include "modeler/observations/observations.hpp"
#include "modeler/registration/registration.hpp"
#include "modeler/ribbon/ribbon_extraction.hpp"

namespace ribbon_mapper {
namespace {

const ModelerConfig& validated(const ModelerConfig& config) {
  config.validate();
  return config;
}

/// Returns the acquisition pose of a line.
TrackedPose acquisition_pose(const ScanLine& line) {
  return {{line.stamp, line.T_map_base}, Eigen::Translation3d(line.odom_origin) * line.T_odom_base};
}

}  // namespace

struct Modeler::State {
  explicit State(const ModelerConfig& config_)
      : config(validated(config_)),
        front_end(config.scan),
        extraction(config.scan, config.ribbon),
        observations(config.trajectory),
        plane_map(config.surface.bridged_gap_m, config.association.slam) {}

  /// Adds the ribbons from `first` on, all of the newest line, to the plane map.
  void associate(std::uint32_t first) {
    const std::vector<Ribbon>& ribbons = observations.ribbons();
    const Pose T_model_base = observations.T_model_base(observations.trajectory().size() - 1);
    for (std::uint32_t i = first; i < ribbons.size(); ++i) {
      plane_map.add({ribbons[i], T_model_base}, i);
    }
  }

  /// Thins the model by an eighth if it has too many ribbons.
  void limit_size() {
    const auto limit = static_cast<std::size_t>(config.observations.max_ribbons);
    const std::size_t count = observations.ribbons().size();
    if (limit == 0 || count <= limit) return;
    const std::vector<std::uint32_t> former_indices = observations.thin(limit - limit / 8);
    thinned += count - former_indices.size();
    plane_map = evaluated(observations.posed(), plane_map.gates(), former_indices);
  }

  /// Refines the poses between corrected ones where these are too sparse for odometry alone.
  void register_lines(Trajectory& trajectory) const {
    const SharedSettings shared{config.scan.range_sigma_m, config.association.corrected,
                                config.surface.bridged_gap_m};
    const std::vector<StampedPose> registered =
        registered_poses(observations.ribbons(), trajectory, config.registration, shared);
    if (!registered.empty()) trajectory.refine(registered);
  }

  /// Returns all ribbons, associated again. Planes keep the ids of those that share most of their
  /// ribbons; `former_indices` are the ribbons' indices in the present map, if they changed.
  PlaneMap evaluated(const PosedObservations& posed, const AssociationGates& gates,
                     const std::vector<std::uint32_t>& former_indices = {}) const {
    PlaneMap map(config.surface.bridged_gap_m, gates, plane_map.next_id());
    for (std::uint32_t i = 0; i < posed.ribbon_count(); ++i) map.add(posed.ribbon(i), i);
    map.take_ids_from(plane_map, former_indices);
    return map;
  }

  ModelerConfig config;
  ScanFrontEnd front_end;       // section 4.1
  RibbonExtraction extraction;  // sections 4.1 and 4.2
  Observations observations;
  PlaneMap plane_map;  // section 4.3
  std::size_t lines = 0, thinned = 0, revision = 0;
};

Modeler::Modeler(const ModelerConfig& config) : state_(std::make_unique<State>(config)) {}
Modeler::~Modeler() = default;
Modeler::Modeler(Modeler&&) noexcept = default;
Modeler& Modeler::operator=(Modeler&&) noexcept = default;

LineResult Modeler::add_scan_line(const LaserBeams& beams, const LinePoses& poses) {
  State& s = *state_;
  ++s.lines;
  LineResult result = s.front_end.add(beams, poses);
  if (result != LineResult::waiting) return result;
  while (const std::optional<ThreeLines> lines = s.front_end.next_three_lines()) {
    const LineObservations& line = s.extraction.extract(*lines);
    if (result != LineResult::modelled) {
      result = line.ribbons.empty() ? LineResult::no_ribbons : LineResult::modelled;
    }
    const std::uint32_t first = s.observations.add_line(acquisition_pose(lines->middle), line);
    s.associate(first);
    s.limit_size();
  }
  return result;
}

void Modeler::correct(const std::vector<StampedPose>& corrected_trajectory) {
  State& s = *state_;
  Trajectory trajectory = s.observations.trajectory();  // the model changes when all is computed
  trajectory.correct(corrected_trajectory);
  s.register_lines(trajectory);
  PlaneMap plane_map =
      s.evaluated(s.observations.posed_at(trajectory), s.config.association.corrected);
  s.observations.move_to(std::move(trajectory));
  s.plane_map = std::move(plane_map);
  ++s.revision;
}

void Modeler::reset() { state_ = std::make_unique<State>(state_->config); }

std::vector<Plane> Modeler::planes_as_built() const {
  const State& s = *state_;
  return assembled_as_built(s.plane_map.hypotheses(), s.plane_map.gates(), s.observations.posed(),
                            s.config.surface, s.config.assembly);
}

std::vector<Plane> Modeler::planes() const {
  const State& s = *state_;
  return assembled_planes(s.plane_map.merged_hypotheses(), s.plane_map.gates(),
                          s.observations.posed(), s.config.surface, s.config.assembly);
}

std::vector<StampedPose> Modeler::trajectory() const {
  return state_->observations.trajectory().poses();
}

const std::vector<Ribbon>& Modeler::ribbons() const { return state_->observations.ribbons(); }

const Observations& Modeler::observations() const { return state_->observations; }

ModelStatistics Modeler::statistics() const {
  return {state_->lines, state_->observations.ribbons().size(), state_->thinned, state_->revision,
          state_->front_end.no_return()};
}

std::size_t Modeler::memory_bytes() const {
  return state_->observations.memory_bytes() + state_->plane_map.memory_bytes();
}

}  // namespace ribbon_mapper
