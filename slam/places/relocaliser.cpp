// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/places/relocaliser.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <sstream>
#include <utility>

#include "slam/lines/line_adjustment.hpp"
#include "slam/matching/planar_pose.hpp"
#include "slam/places/evident_slip.hpp"

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

/// Returns the lines near the newest ones, where these are and where a move takes them.
std::vector<std::uint32_t> compared_lines(const Finding& finding, const PosedLines& lines,
                                          const EstimateConfig& config) {
  const LineRange newest = newest_within(lines, config.relocaliser.query_s);
  std::vector<Eigen::Vector3d> places = places_of(lines, newest);
  if (finding.move) {
    const std::vector<Eigen::Vector3d> moved =
        places_of(lines, newest, finding.move->T_start_start);
    places.insert(places.end(), moved.begin(), moved.end());
  }
  return lines_near(places, config.context_radius_m, lines, lines.size(), config);
}

std::string text_of(const HistoryCost& before, const HistoryCost& after) {
  std::ostringstream text;
  text << after.planes << " planes and " << after.unexplained
       << " single ribbons explain what took " << before.planes << " and " << before.unexplained;
  return text.str();
}

}  // namespace

void Relocaliser::forget_lines() {
  finder_.forget_breaks();
  way_back_.reset();
  proposal_.reset();
}

void Relocaliser::decide(Decision::Kind kind, const PosedLines& lines, const std::string& reason) {
  is_lost_ = kind == Decision::Kind::lost;
  decisions_.push_back({kind, lines.stamp(lines.size() - 1), reason});
}

bool Relocaliser::look(PosedLines& lines, double tracked_share, const OdometryNoise& noise) {
  if (way_back_ && lines.stamp(lines.size() - 1) > way_back_until_) way_back_.reset();
  const Finding finding = finder_.find(lines, tracked_share, max_scale(noise));
  if (choose(finding, lines, noise)) return true;
  // A move that was not made does not explain more in the end.
  const bool is_doubted =
      !finding.doubt.empty() && !(finding.move && finding.doubt == finding.move->evidence);
  if (is_doubted && !is_lost_) decide(Decision::Kind::lost, lines, finding.doubt);
  if (!is_doubted && is_lost_) {
    decide(Decision::Kind::kept, lines, "nothing contradicts that this is new ground");
  }
  return false;
}

/// Returns the largest scale of the odometry's noise that is still drift.
double Relocaliser::max_scale(const OdometryNoise& noise) const {
  return settings_.estimate.relocaliser.drift_sigmas * noise.planar_scale;
}

/// Returns true if a move goes farther than a slip, and nothing contradicts that the robot is where
/// it seems to be. A turn at a place of its way may still have led it there; drift has not, as
/// walls were followed all along.
bool Relocaliser::is_far(const FoundMove& move, const PosedLines& lines) const {
  return !move.is_contradicted && distance_at(lines.size() - 1, move.T_start_start, lines) >
                                      settings_.estimate.relocaliser.radius_m;
}

/// Returns true if a slip within a seam may have made a move.
bool Relocaliser::is_possible(const Seam& slip, const Pose& T_start_start,
                              const PosedLines& lines) const {
  const RelocaliserConfig& config = settings_.estimate.relocaliser;
  return distance_at(slip.end, T_start_start, lines) <= config.radius_m &&
         may_slip(slip, T_start_start, lines, config.drift_sigmas);
}

/// Returns the history in which a move was made by a slip that the lines around it show, if any
/// do. It may lie as far before the last known ground as the window is wide, and not too long ago.
std::optional<Relocaliser::Candidate> Relocaliser::evident_history(const FoundMove& move,
                                                                   const PosedLines& lines) const {
  const std::uint32_t known = std::min(move.seam.first, move.last_seen);
  const std::uint32_t first = lines_before(settings_.estimate.window_s, lines, known).first;
  const LineRange doubted{std::max(first, first_within(lines, kMemory_s)), lines.size()};
  const auto slip = evident_slip(lines, doubted, move.T_start_start, settings_);
  if (!slip || !is_possible(slip->seam, move.T_start_start, lines)) return std::nullopt;
  return Candidate{move.T_start_start, slip->seam, true, Decision::Kind::found, 0.0, slip->ribbons};
}

/// Returns the histories that may explain what was found, and the one without the last move.
std::vector<Relocaliser::Candidate> Relocaliser::candidates(const Finding& finding,
                                                            const PosedLines& lines,
                                                            const OdometryNoise& noise) const {
  std::vector<Candidate> candidates;
  if (way_back_ && !finding.doubt.empty()) candidates.push_back(*way_back_);
  if (!finding.move) return candidates;
  if (const auto history = evident_history(*finding.move, lines)) {
    candidates.push_back(*history);
    return candidates;
  }
  const Pose& T = finding.move->T_start_start;
  const Seam& seam = finding.move->seam;
  const auto add_slip = [&](const Seam& where, double lead = 0.0) {
    if (is_possible(where, T, lines))
      candidates.push_back({T, where, true, Decision::Kind::found, lead});
  };
  // That known walls stood before what was in view is evidence of its own: another place must save
  // a plane.
  if (const auto& tear = finding.move->tear) {
    add_slip({*tear, *tear}, settings_.registration.min_ribbons);
  }
  if (lines.seconds_between(seam.first, seam.end) < kShortSeam_s) {
    add_slip(seam);
    return candidates;
  }
  // What was seen in the meantime belongs to what was seen before, to what is seen now, or to both.
  add_slip({seam.end, seam.end});
  add_slip({seam.first, seam.first});
  if (seam.split) add_slip({*seam.split, *seam.split});
  const Seam way{std::max<std::uint32_t>(1, finding.move->last_seen), seam.end};
  if (finding.move->tear || way.first >= way.end) return candidates;  // it began to be wrong there
  if (const auto pivot = pivot_of(way, T, lines)) add_slip({*pivot, *pivot});
  if (!is_far(*finding.move, lines) && scale_of(way, T, lines) < max_scale(noise)) {
    candidates.push_back({T, way, false, Decision::Kind::found});
  }
  return candidates;
}

/// Returns the lines moved and adjusted.
PosedLines Relocaliser::history_with(const Candidate& candidate, const PosedLines& lines,
                                     const OdometryNoise& noise) const {
  PosedLines history = lines;
  const Seam& seam = candidate.seam;
  move_behind(seam, candidate.T_start_start, history);
  for (std::uint32_t i = seam.first; i <= seam.end; ++i) history.set_slip(i, candidate.is_slip);
  const EstimateConfig& config = settings_.estimate;
  const std::uint32_t first = std::min(seam.first, first_within(history, config.window_s));
  const LineRange range{first, history.size()};
  adjust_lines(history, {first, range.end, context_of(history, range, first, config)}, noise,
               settings_);
  return history;
}

/// Returns the history of least cost among some, if it costs less than the lines as they are.
std::optional<Relocaliser::Choice> Relocaliser::best_of(const std::vector<Candidate>& histories,
                                                        const Finding& finding,
                                                        const PosedLines& lines,
                                                        const OdometryNoise& noise) const {
  const EstimateConfig& config = settings_.estimate;
  const std::vector<std::uint32_t> compared = compared_lines(finding, lines, config);
  const HistoryCost before = history_cost(lines, compared, settings_);
  double least = before.total - settings_.registration.min_ribbons;  // one plane less
  std::optional<Choice> best;
  for (const Candidate& candidate : histories) {
    PosedLines history = history_with(candidate, lines, noise);
    const HistoryCost after = history_cost(history, compared, settings_);
    // Ribbons seen through known walls contradict them: they are not explained either.
    const bool is_move = candidate.kind == Decision::Kind::found && before.ribbon_m > 0.0;
    const double freed = is_move ? finding.move->freed_m / before.ribbon_m : 0.0;
    const double total = after.total - candidate.saved - freed;
    // Known walls may be wrong themselves, and other places look alike: what is seen through walls
    // or shows a slip moves nothing alone.
    if (after.total >= before.total || total >= least) continue;
    // New ground may look like known ground in part.
    const bool explains_more =
        after.planes < before.planes && after.unexplained <= before.unexplained;
    if (is_move && finding.move->is_partial && !explains_more) continue;
    least = total - candidate.lead;
    best = Choice{candidate, std::move(history), before, after};
  }
  return best;
}

/// Keeps a move as this look's proposal. Returns true if the look before has proposed the same.
bool Relocaliser::propose(const Candidate& candidate, const PosedLines& lines) {
  const std::uint32_t last = lines.size() - 1;
  const double since_s = 1.5 * settings_.estimate.window_step_s;
  const std::optional<Proposal> before =
      std::exchange(proposal_, Proposal{candidate.T_start_start, lines.stamp(last)});
  if (!before || lines.stamp(last) - before->stamp > from_seconds(since_s)) return false;
  return is_same_move(before->T_start_start, candidate.T_start_start, lines.T_start_base(last));
}

/// Returns false for moves that are made when the next look finds them again. Two corridors look
/// alike at a glance, and farther away than a slip goes, more places do.
bool Relocaliser::is_clear(const Choice& choice, const FoundMove& move,
                           const PosedLines& lines) const {
  const bool is_shown = choice.candidate.saved > 0.0 || choice.after.planes < choice.before.planes;
  return is_shown && !is_far(move, lines);
}

/// Makes the move of least cost. Returns false if none costs less than no move.
bool Relocaliser::choose(const Finding& finding, PosedLines& lines, const OdometryNoise& noise) {
  const std::vector<Candidate> histories = candidates(finding, lines, noise);
  if (histories.empty()) return false;
  std::optional<Choice> choice = best_of(histories, finding, lines, noise);
  if (!choice) return false;
  const Candidate& chosen = choice->candidate;
  const bool is_found = chosen.kind == Decision::Kind::found;
  if (is_found && !is_clear(*choice, *finding.move, lines) && !propose(chosen, lines)) return false;
  lines = std::move(choice->lines);
  decide(chosen.kind, lines,
         (is_found ? finding.move->evidence : finding.doubt) + "; " +
             text_of(choice->before, choice->after));
  forget_lines();
  if (!is_found) return true;
  way_back_ = Candidate{chosen.T_start_start.inverse(Eigen::Isometry),
                        chosen.seam,
                        false,
                        Decision::Kind::undone,
                        0.0,
                        -chosen.saved};
  way_back_until_ =
      lines.stamp(lines.size() - 1) + from_seconds(settings_.estimate.relocaliser.probation_s);
  return true;
}

}  // namespace ribbon_mapper::slam
