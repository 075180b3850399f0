// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/places/relocaliser.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

#include "slam/lines/line_adjustment.hpp"

namespace ribbon_mapper::slam {
namespace {

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
  const Finding finding =
      finder_.find(lines, tracked_share, max_drift_scale(noise, settings_.estimate.relocaliser));
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

/// Returns the histories that may explain what was found, and the one without the last move.
std::vector<CandidateHistory> Relocaliser::candidates(const Finding& finding,
                                                      const PosedLines& lines,
                                                      const OdometryNoise& noise) const {
  std::vector<CandidateHistory> candidates;
  if (finding.move) candidates = candidate_histories(*finding.move, lines, noise, settings_);
  if (way_back_ && !finding.doubt.empty()) candidates.insert(candidates.begin(), *way_back_);
  return candidates;
}

/// Returns the lines moved, and adjusted from `first` on.
PosedLines Relocaliser::history_with(const CandidateHistory& candidate, std::uint32_t first,
                                     const PosedLines& lines, const OdometryNoise& noise) const {
  PosedLines history = lines;
  const Seam& seam = candidate.seam;
  move_behind(seam, candidate.T_start_start, history);
  for (std::uint32_t i = seam.first; i <= seam.end; ++i) history.set_slip(i, candidate.is_slip);
  const EstimateConfig& config = settings_.estimate;
  const LineRange range{first, history.size()};
  adjust_lines(history, {first, range.end, context_of(history, range, first, config), {}}, noise,
               settings_);
  return history;
}

/// Returns the history of least cost among some, if it costs less than the lines as they are.
std::optional<Relocaliser::Choice> Relocaliser::best_of(
    const std::vector<CandidateHistory>& histories, const Finding& finding, const PosedLines& lines,
    const OdometryNoise& noise) const {
  const EstimateConfig& config = settings_.estimate;
  const std::vector<std::uint32_t> compared = compared_lines(finding, lines, config);
  const HistoryCost before = history_cost(lines, compared, settings_);
  const double most = before.total - settings_.registration.min_ribbons;  // one plane less
  double least = std::numeric_limits<double>::infinity();
  std::optional<Choice> best;
  // All are adjusted alike: a history that may bend more lines explains more.
  std::uint32_t first = first_within(lines, config.window_s);
  for (const CandidateHistory& candidate : histories) first = std::min(first, candidate.seam.first);
  for (const CandidateHistory& candidate : histories) {
    PosedLines history = history_with(candidate, first, lines, noise);
    const HistoryCost after = history_cost(history, compared, settings_);
    // Ribbons seen through known walls contradict them: they are not explained either.
    const bool is_move = candidate.kind == Decision::Kind::found && before.ribbon_m > 0.0;
    const double freed = is_move ? finding.move->freed_m / before.ribbon_m : 0.0;
    const double total = after.total - candidate.saved - freed;
    // Known walls may be wrong themselves, and other places look alike: what is seen through walls
    // or shows a slip moves nothing alone.
    if (after.total >= before.total || total >= most) continue;
    // Among those that may be, what lines show around a slip tells where it was.
    const double cost = total - candidate.evidence.ribbons;
    if (cost >= least) continue;
    // New ground may look like known ground in part.
    const bool explains_more =
        after.planes < before.planes && after.unexplained <= before.unexplained;
    if (is_move && finding.move->is_partial && !explains_more) continue;
    least = cost - candidate.lead;
    best = Choice{candidate, std::move(history), before, after};
  }
  return best;
}

/// Keeps a move as this look's proposal. Returns true if the look before has proposed the same.
bool Relocaliser::propose(const CandidateHistory& candidate, const PosedLines& lines) {
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
  return is_shown && !is_far(move, lines, settings_.estimate.relocaliser);
}

/// Makes the move of least cost. Returns false if none costs less than no move.
bool Relocaliser::choose(const Finding& finding, PosedLines& lines, const OdometryNoise& noise) {
  const std::vector<CandidateHistory> histories = candidates(finding, lines, noise);
  if (histories.empty()) return false;
  std::optional<Choice> choice = best_of(histories, finding, lines, noise);
  if (!choice) return false;
  const CandidateHistory& chosen = choice->candidate;
  const bool is_found = chosen.kind == Decision::Kind::found;
  if (is_found && !is_clear(*choice, *finding.move, lines) && !propose(chosen, lines)) return false;
  lines = std::move(choice->lines);
  decide(chosen.kind, lines,
         (is_found ? finding.move->evidence : finding.doubt) + "; " +
             text_of(choice->before, choice->after));
  forget_lines();
  if (!is_found) return true;
  way_back_ = chosen.taken_back();
  way_back_until_ =
      lines.stamp(lines.size() - 1) + from_seconds(settings_.estimate.relocaliser.probation_s);
  return true;
}

}  // namespace ribbon_mapper::slam
