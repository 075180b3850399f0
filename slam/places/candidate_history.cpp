// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/places/candidate_history.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "modeler/geometry/angles.hpp"
#include "slam/matching/planar_pose.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr double kShortSeam_s = 3.0;  // longer than a slip or a push
constexpr double kMemory_s = 300.0;   // each second that is asked for a slip costs time
constexpr double kPivot = 0.25;       // a turn displaces it by less of what it does to the robot

/// Returns false if a source beside the wheels has measured the steps of a seam, and excludes that
/// the robot was moved there: a level laser sees that it did not slip.
bool may_slip(const Seam& seam, const Pose& T_start_start, const PosedLines& lines,
              double max_sigmas) {
  if (!lines.has_source()) return true;
  const Pose T_start_base = lines.T_start_base(seam.end);
  const Pose moved = T_start_base.inverse(Eigen::Isometry) * T_start_start * T_start_base;
  const Eigen::Vector3d error = planar(moved).vector();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::uint32_t i = seam.first; i <= seam.end; ++i) covariance += lines.source_covariance(i);
  return error.dot(covariance.ldlt().solve(error)) <= max_sigmas * max_sigmas;
}

/// Returns the distance that a move takes the robot at a line [m].
double distance_at(std::uint32_t line, const Pose& T_start_start, const PosedLines& lines) {
  const Eigen::Vector3d place = lines.T_start_base(line).translation();
  return (T_start_start * place - place).norm();
}

/// Returns the line of a seam about which a move turns the newest one: the turn was made there.
/// Nothing if it shifts all lines of the seam.
std::optional<std::uint32_t> pivot_of(const Seam& seam, const Pose& T_start_start,
                                      const PosedLines& lines) {
  std::optional<std::uint32_t> pivot;
  double least_m = kPivot * distance_at(lines.size() - 1, T_start_start, lines);
  for (std::uint32_t i = seam.first; i <= seam.end; ++i) {
    const double distance_m = distance_at(i, T_start_start, lines);
    if (distance_m < least_m) least_m = distance_m, pivot = i;
  }
  return pivot;
}

/// The histories that may explain one move.
class Candidates {
 public:
  Candidates(const FoundMove& move, const PosedLines& lines, const OdometryNoise& noise,
             const EstimateSettings& settings)
      : move_(move), lines_(lines), noise_(noise), settings_(settings) {}

  /// Returns all of them.
  std::vector<CandidateHistory> all() {
    // The odometry may have failed as far before the last known ground as the window is wide.
    const std::uint32_t known = std::min(move_.seam.first, move_.last_seen),
                        oldest = first_within(lines_, kMemory_s);
    const std::uint32_t doubted =
        std::max(oldest, lines_before(settings_.estimate.window_s, lines_, known).first);
    for (const FittingSlip& slip : slips_in({doubted, lines_.size()})) {
      if (slip.evidence.is_explained && is_slip(slip.seam)) {
        found_ = {slip_within(slip.seam)};
        found_.back().saved = slip.evidence.ribbons;
        return found_;
      }
      add_slip(slip.seam);
    }
    // That known walls stood before what was in view is evidence of its own: another place must
    // save a plane.
    if (move_.tear) add_slip({*move_.tear, *move_.tear}, settings_.registration.min_ribbons);
    if (lines_.seconds_between(move_.seam.first, move_.seam.end) < kShortSeam_s)
      add_slip(move_.seam);
    else
      add_long_way();
    if (!move_.tear) {  // else, it began to be wrong there
      for (const FittingSlip& slip : slips_in({oldest, doubted})) add_slip(slip.seam);
    }
    leave_out_contradicted();
    return found_;
  }

 private:
  const RelocaliserConfig& config() const { return settings_.estimate.relocaliser; }

  std::vector<FittingSlip> slips_in(const LineRange& range) const {
    return fitting_slips(lines_, range, move_.T_start_start, settings_);
  }
  /// Returns true if a slip within a seam may have made the move.
  bool is_slip(const Seam& seam) const {
    return distance_at(seam.end, move_.T_start_start, lines_) <= config().radius_m &&
           may_slip(seam, move_.T_start_start, lines_, config().drift_sigmas);
  }
  CandidateHistory slip_within(const Seam& seam) const {
    CandidateHistory slip{move_.T_start_start, seam, true, Decision::Kind::found};
    slip.evidence = slip_evidence(lines_, seam.first, move_.T_start_start, settings_);
    return slip;
  }

  /// Adds a slip within a seam, if it may have made the move and is not there yet.
  void add_slip(const Seam& seam, double lead = 0.0) {
    const bool is_there = std::any_of(found_.begin(), found_.end(), [&](const auto& other) {
      return other.seam.first == seam.first && other.seam.end == seam.end;
    });
    if (is_there || !is_slip(seam)) return;
    found_.push_back(slip_within(seam));
    found_.back().lead = lead;
  }
  void add_slip_at(std::uint32_t line) { add_slip({line, line}); }

  /// Leaves out the slips that lines contradict, unless nothing else is left.
  void leave_out_contradicted() {
    const auto contradicted = std::stable_partition(
        found_.begin(), found_.end(),
        [](const CandidateHistory& history) { return !history.evidence.is_contradicted; });
    if (contradicted != found_.begin()) found_.erase(contradicted, found_.end());
  }

  /// Adds the places between two ends of a seam that are far apart. What was seen in the meantime
  /// belongs to what was seen before, to what is seen now, or to both.
  void add_long_way() {
    add_slip_at(move_.seam.end);
    add_slip_at(move_.seam.first);
    if (move_.seam.split) add_slip_at(*move_.seam.split);
    const Seam way{std::max<std::uint32_t>(1, move_.last_seen), move_.seam.end};
    if (move_.tear || way.first >= way.end) return;  // it began to be wrong there
    if (const auto pivot = pivot_of(way, move_.T_start_start, lines_)) add_slip_at(*pivot);
    if (is_drift(way)) {
      found_.push_back({move_.T_start_start, way, false, Decision::Kind::found});
    }
  }

  /// Returns true if drift on a way may have made the move. Walls were followed all along, so it
  /// turns the robot by no more than the angle by which they may be taken for one another.
  bool is_drift(const Seam& way) const {
    const double max_turn_rad = settings_.estimate.gates.front().angle_deg * kDegree;
    return !is_far(move_, lines_, config()) &&
           std::abs(planar(move_.T_start_start).yaw_rad) <= max_turn_rad &&
           scale_of(way, move_.T_start_start, lines_) < max_drift_scale(noise_, config());
  }

  const FoundMove& move_;
  const PosedLines& lines_;
  const OdometryNoise& noise_;
  const EstimateSettings& settings_;
  std::vector<CandidateHistory> found_;
};

}  // namespace

CandidateHistory CandidateHistory::taken_back() const {
  CandidateHistory without = *this;
  without.T_start_start = T_start_start.inverse(Eigen::Isometry);
  without.is_slip = false;
  without.kind = Decision::Kind::undone;
  without.lead = 0.0;
  without.evidence = {};
  without.saved = -saved;
  return without;
}

double max_drift_scale(const OdometryNoise& noise, const RelocaliserConfig& config) {
  return config.drift_sigmas * noise.planar_scale;
}

bool is_far(const FoundMove& move, const PosedLines& lines, const RelocaliserConfig& config) {
  // A turn at a place of its way may still have led it there; drift has not, as walls were followed
  // all along.
  return !move.is_contradicted &&
         distance_at(lines.size() - 1, move.T_start_start, lines) > config.radius_m;
}

std::vector<CandidateHistory> candidate_histories(const FoundMove& move, const PosedLines& lines,
                                                  const OdometryNoise& noise,
                                                  const EstimateSettings& settings) {
  return Candidates(move, lines, noise, settings).all();
}

}  // namespace ribbon_mapper::slam
