// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/modeler.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "modeler/assembly/plane_assembly.hpp"
#include "modeler/association/checkpoints.hpp"
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

/// Returns the parts, which take no line that the trajectory has.
ScanFrontEnd::Parts with_last_stamp(ScanFrontEnd::Parts parts, const Trajectory& trajectory) {
  if (trajectory.size() > 0) parts.last_stamp = trajectory.recorded().stamps().back();
  return parts;
}

}  // namespace

struct Modeler::State {
  explicit State(const ModelerConfig& config_)
      : config(validated(config_)),
        front_end(config.scan),
        extraction(config.scan, config.ribbon),
        observations(config.trajectory),
        evaluation(empty_evaluation(config.association.slam)) {}

  State(const ModelerConfig& config_, SavedModel saved)
      : config(validated(config_)),
        front_end(config.scan,
                  with_last_stamp(std::move(saved.waiting), saved.observations.trajectory())),
        extraction(config.scan, config.ribbon),
        observations(std::move(saved.observations)),
        evaluation(empty_evaluation(observations.trajectory().is_corrected()
                                        ? config.association.corrected
                                        : config.association.slam)),
        lines(saved.lines),
        thinned(saved.thinned),
        revision(saved.revision),
        associated_again(saved.associated_again) {
    complete(observations.trajectory(), evaluation);
    evaluation.map.take_ids(saved.plane_ids, saved.next_plane_id);
  }

  /// The first ribbons, associated one after the other. Has checkpoints if poses are corrected.
  struct Evaluation {
    PlaneMap map;
    Checkpoints checkpoints;
    std::uint32_t ribbons = 0;  // that are associated
  };

  /// Returns an evaluation before the first ribbon, whose hypotheses get ids from `first_id` on.
  Evaluation empty_evaluation(const AssociationGates& gates, std::int64_t first_id = 0) const {
    return {PlaneMap(config.surface.bridged_gap_m, gates, first_id),
            Checkpoints(config.association.checkpoint_ribbons)};
  }

  /// Adds the next ribbons, which are those of one line, to an evaluation of `all` ribbons.
  void add_line(const Pose& T_model_base, bool is_corrected, std::uint32_t all,
                Evaluation& made) const {
    const std::vector<Ribbon>& ribbons = observations.ribbons();
    if (is_corrected) made.checkpoints.offer(made.map, made.ribbons, all);
    const std::uint32_t line = ribbons[made.ribbons].pose;
    for (std::uint32_t& i = made.ribbons; i < ribbons.size() && ribbons[i].pose == line; ++i) {
      made.map.add({ribbons[i], T_model_base}, i);
    }
  }

  /// Adds the ribbons of the newest line, if it has any, to the evaluation.
  void associate() {
    if (evaluation.ribbons == observations.ribbons().size()) return;
    const Trajectory& trajectory = observations.trajectory();
    add_line(observations.T_model_base(trajectory.size() - 1), trajectory.is_corrected(),
             evaluation.ribbons, evaluation);
  }

  /// Adds all further ribbons to an evaluation, at the poses of a trajectory.
  void complete(const Trajectory& trajectory, Evaluation& made) const {
    const std::vector<Ribbon>& ribbons = observations.ribbons();
    if (ribbons.empty()) return;
    const auto all = static_cast<std::uint32_t>(ribbons.size());
    const Pose T_model_map = trajectory.T_map_base(0).inverse(Eigen::Isometry);
    while (made.ribbons < all) {
      const Pose T_map_base = trajectory.T_map_base(ribbons[made.ribbons].pose);
      add_line(T_model_map * T_map_base, trajectory.is_corrected(), all, made);
    }
  }

  /// Returns the evaluation as far as another trajectory leaves it unchanged, or less.
  Evaluation unchanged_part(const Trajectory& trajectory) const {
    const AssociationGates& gates = config.association.corrected;
    const std::int64_t first_id = evaluation.map.next_id();
    if (!observations.trajectory().is_corrected()) return empty_evaluation(gates, first_id);
    const std::size_t lines_unmoved = trajectory.common_with(observations.trajectory());
    const auto unmoved = observations.first_ribbon_of(lines_unmoved);
    const Checkpoints& checkpoints = evaluation.checkpoints;
    if (unmoved == evaluation.ribbons && config.association.checkpoint_ribbons > 0) {
      return {evaluation.map.restored(evaluation.map.state(), first_id), checkpoints, unmoved};
    }
    const Checkpoints::Checkpoint* const last = checkpoints.last_until(unmoved);
    if (!last) return empty_evaluation(gates, first_id);
    return {evaluation.map.restored(last->state, first_id), checkpoints.until(unmoved),
            last->ribbons};
  }

  /// Thins the model by an eighth if it has too many ribbons.
  void limit_size() {
    const auto limit = static_cast<std::size_t>(config.observations.max_ribbons);
    const std::size_t count = observations.ribbons().size();
    if (limit == 0 || count <= limit) return;
    const std::vector<std::uint32_t> former_indices = observations.thin(limit - limit / 8);
    thinned += count - former_indices.size();
    const PlaneMap& before = evaluation.map;
    Evaluation thin = empty_evaluation(before.gates(), before.next_id());
    complete(observations.trajectory(), thin);
    thin.map.take_ids_from(before, former_indices);
    evaluation = std::move(thin);
  }

  /// Refines the poses between corrected ones where these are too sparse for odometry alone.
  void register_lines(Trajectory& trajectory) const {
    const SharedSettings shared{config.scan.range_sigma_m, config.association.corrected,
                                config.surface.bridged_gap_m};
    const std::vector<StampedPose> registered =
        registered_poses(observations.ribbons(), trajectory, config.registration, shared);
    if (!registered.empty()) trajectory.refine(registered);
  }

  ModelerConfig config;
  ScanFrontEnd front_end;       // section 4.1
  RibbonExtraction extraction;  // sections 4.1 and 4.2
  Observations observations;
  Evaluation evaluation;  // section 4.3
  std::size_t lines = 0, thinned = 0, revision = 0, associated_again = 0;
};

Modeler::Modeler(const ModelerConfig& config) : state_(std::make_unique<State>(config)) {}
Modeler::Modeler(const ModelerConfig& config, SavedModel saved)
    : state_(std::make_unique<State>(config, std::move(saved))) {}
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
    s.observations.add_line(acquisition_pose(lines->middle), line);
    s.associate();
    s.limit_size();
  }
  return result;
}

void Modeler::correct(const std::vector<StampedPose>& corrected_trajectory) {
  State& s = *state_;
  Trajectory trajectory = s.observations.trajectory();  // the model changes when all is computed
  trajectory.correct(corrected_trajectory);
  s.register_lines(trajectory);
  State::Evaluation evaluation = s.unchanged_part(trajectory);
  const std::uint32_t unchanged = evaluation.ribbons;
  s.complete(trajectory, evaluation);
  evaluation.map.take_ids_from(s.evaluation.map);
  s.observations.move_to(std::move(trajectory));
  s.evaluation = std::move(evaluation);
  s.associated_again += s.evaluation.ribbons - unchanged;
  ++s.revision;
}

void Modeler::reset() { state_ = std::make_unique<State>(state_->config); }

std::vector<Plane> Modeler::planes_as_built() const {
  const State& s = *state_;
  return assembled_as_built(s.evaluation.map.hypotheses(), s.evaluation.map.gates(),
                            s.observations.posed(), s.config.surface, s.config.assembly);
}

std::vector<Plane> Modeler::planes() const { return plane_model().planes; }

PlaneModel Modeler::plane_model() const {
  const State& s = *state_;
  AssemblyConfig assembly = s.config.assembly;
  // With drift, beams seem to pass walls.
  if (!s.observations.trajectory().is_corrected()) assembly.passed_lines = 0;
  return assembled_planes(s.evaluation.map.merged_hypotheses(), s.evaluation.map.gates(),
                          s.observations.posed(), s.config.surface, assembly);
}

std::vector<StampedPose> Modeler::trajectory() const {
  return state_->observations.trajectory().poses();
}

const std::vector<Ribbon>& Modeler::ribbons() const { return state_->observations.ribbons(); }

const Observations& Modeler::observations() const { return state_->observations; }

ScanFrontEnd::Parts Modeler::waiting() const { return state_->front_end.parts(); }

const ModelerConfig& Modeler::config() const { return state_->config; }

std::vector<std::int64_t> Modeler::plane_ids() const {
  return state_->evaluation.map.ids_of_ribbons();
}

std::int64_t Modeler::next_plane_id() const { return state_->evaluation.map.next_id(); }

ModelStatistics Modeler::statistics() const {
  const State& s = *state_;
  return {s.lines,
          s.observations.ribbons().size(),
          s.thinned,
          s.revision,
          s.associated_again,
          s.front_end.no_return()};
}

std::size_t Modeler::memory_bytes() const {
  const State::Evaluation& evaluation = state_->evaluation;
  return state_->observations.memory_bytes() + evaluation.map.memory_bytes() +
         evaluation.checkpoints.memory_bytes(evaluation.map);
}

}  // namespace ribbon_mapper
