// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/tilting/relocaliser.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <sstream>

#include "modeler/geometry/angles.hpp"
#include "slam/tilting/line_adjustment.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr double kShortSeam_s = 3.0;  // longer than a slip or a push
constexpr double kSameScene_m = 2.0;  // a quarter of the context's radius

int percent(double share) { return static_cast<int>(std::lround(100.0 * share)); }

std::string text_of(const Agreement& agreement) {
  std::ostringstream text;
  text << percent(agreement.known()) << " % of the walls in view are known, "
       << percent(agreement.pierced()) << " % are seen through known ones";
  return text.str();
}

std::string text_of(const PlaceMove& move) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "a move of " << move.at_robot.translation().norm()
       << " m and " << std::setprecision(1) << to_degrees(move.at_robot.yaw_rad) << " degrees";
  return text.str();
}

std::string text_of(const HistoryCost& before, const HistoryCost& after) {
  std::ostringstream text;
  text << after.planes << " planes and " << after.unexplained
       << " single ribbons explain what took " << before.planes << " and " << before.unexplained;
  return text.str();
}

/// Returns the history of a candidate, adjusted.
PosedLines history_with(const Seam& seam, const Pose& T_start_start, bool is_slip,
                        const PosedLines& lines, const OdometryNoise& noise,
                        const EstimateSettings& settings) {
  PosedLines history = lines;
  move_behind(seam, T_start_start, history);
  for (std::uint32_t i = seam.first; i <= seam.end; ++i) history.set_slip(i, is_slip);
  const std::uint32_t first =
      std::min(seam.first, first_within(history, settings.estimate.window_s));
  const LineRange range{first, history.size()};
  adjust_lines(history,
               {range.first, range.end, context_of(history, range, first, settings.estimate)},
               noise, settings);
  return history;
}

/// Returns the line at which most of the walls that moved lines see had been seen for the last
/// time: a quarter of them, by length, were in sight until then, or later.
std::uint32_t last_seen(const PosedLines& lines, const LineRange& range, const Pose& T_start_start,
                        const KnownScene& scene, const AssociationGates& gates) {
  std::vector<std::pair<std::uint32_t, double>> seen;  // line and length
  double total = 0.0;
  for (std::uint32_t i = lines.first_ribbon(range.first); i < lines.first_ribbon(range.end); ++i) {
    const PosedRibbon ribbon(lines.ribbon(i),
                             T_start_start * lines.T_start_base(lines.ribbon(i).pose));
    if (!is_of_wall(ribbon.normal)) continue;
    const KnownScene::Wall* wall = scene.wall_of(ribbon, gates);
    if (wall == nullptr) continue;
    seen.emplace_back(wall->last_line, ribbon.ribbon->length_m);
    total += ribbon.ribbon->length_m;
  }
  std::sort(seen.begin(), seen.end());
  double sum = 0.0;
  for (const auto& [line, length] : seen) {
    sum += length;
    if (sum >= 0.75 * total) return line;
  }
  return range.first;
}

/// Returns true if the lines just behind a seam fit known walls clearly better when moved.
bool is_sharp(const Seam& seam, const PosedLines& lines, const LineRange& range,
              const Pose& T_start_start, const KnownScene& scene, const EstimateConfig& config) {
  LineRange behind{seam.end, seam.end};
  while (behind.end < range.end &&
         lines.seconds_between(behind.first, behind.end) < 0.5 * config.relocaliser.query_s)
    ++behind.end;
  const Agreement here = agreement_of(lines, behind, Pose::Identity(), scene, config.gates.front());
  const Agreement moved = agreement_of(lines, behind, T_start_start, scene, config.gates.front());
  return moved.seen_m > 0.0 && moved.known() >= config.relocaliser.least_known &&
         moved.evidence_m() - here.evidence_m() >= config.relocaliser.least_gain * moved.seen_m;
}

}  // namespace

void Relocaliser::forget_lines() {
  breaks_.clear();
  on_probation_.reset();
}

void Relocaliser::decide(Decision::Kind kind, const PosedLines& lines, const std::string& reason) {
  is_lost_ = kind == Decision::Kind::lost;
  decisions_.push_back({kind, lines.stamp(lines.size() - 1), reason});
}

bool Relocaliser::look(PosedLines& lines, double tracked_share, const OdometryNoise& noise) {
  const EstimateConfig& config = settings_.estimate;
  const LineRange query{first_within(lines, config.relocaliser.query_s), lines.size()};
  if (query.first < 2) return false;
  find_.reset();
  doubt_.clear();
  look_at_recent(lines, query, tracked_share);
  for (std::size_t i = breaks_.size(); i-- > 0;) {
    if (!search_before(breaks_[i], lines, query)) continue;
    breaks_.resize(i);  // later ones lie on ground that is right as well
    break;
  }
  if (choose(lines, query, noise)) return true;
  if (!doubt_.empty() && !is_lost_) decide(Decision::Kind::lost, lines, doubt_);
  if (doubt_.empty() && is_lost_) {
    decide(Decision::Kind::kept, lines, "nothing contradicts that this is new ground");
  }
  return false;
}

/// Compares the newest lines with all older ones if they show unknown walls. Opens a break there.
void Relocaliser::look_at_recent(const PosedLines& lines, const LineRange& query,
                                 double tracked_share) {
  const EstimateConfig& config = settings_.estimate;
  const Time now = lines.stamp(lines.size() - 1);
  if (tracked_share < config.relocaliser.known_share) {
    doubted_until_ = now + from_seconds(config.relocaliser.query_s);
  }
  if (now >= doubted_until_) {
    if (!breaks_.empty()) breaks_.back().is_settled = true;
    return;
  }
  const KnownScene recent(lines, context_of(lines, query, query.first, config), settings_);
  open_break(query, agreement_of(lines, query, Pose::Identity(), recent, config.gates.front()));
  if (!breaks_.empty() && breaks_.back().line < query.first) {
    consider(lines, query, query.first, recent);
  }
}

/// Opens a break where known ground ends, by what older lines know of the newest ones.
void Relocaliser::open_break(const LineRange& query, const Agreement& now) {
  constexpr std::size_t kMostBreaks = 3;
  const bool is_known = is_known_ground(now, settings_.estimate.relocaliser);
  if (is_known && !breaks_.empty()) breaks_.back().is_settled = true;
  if (is_known || (!breaks_.empty() && !breaks_.back().is_settled)) return;
  if (breaks_.size() == kMostBreaks) breaks_.erase(breaks_.begin());
  breaks_.emplace_back().line = query.first;
}

/// Returns what was known before a break near the newest line.
const KnownScene& Relocaliser::scene_before(Break& torn, const PosedLines& lines) const {
  const EstimateConfig& config = settings_.estimate;
  const std::uint32_t last = lines.size() - 1;
  const Eigen::Vector3d here = lines.T_start_base(last).translation();
  // Poses do not change any more when they have left the window.
  const bool is_final = lines.seconds_between(torn.line, last) > 2.0 * config.window_s;
  if (!is_final || !torn.scene || (here - torn.centre).norm() > kSameScene_m) {
    torn.scene.emplace(lines, context_of(lines, {last, lines.size()}, torn.line, config),
                       settings_);
    torn.centre = here;
  }
  return *torn.scene;
}

/// Searches for lines behind a break on what was known before it. Returns true if the break is to
/// be closed.
bool Relocaliser::search_before(Break& torn, const PosedLines& lines, const LineRange& query) {
  const EstimateConfig& config = settings_.estimate;
  const AssociationGates gates = config.gates.front();
  const RelocaliserConfig& limits = config.relocaliser;
  const LineRange newest{std::max(query.first, torn.line), query.end};
  const KnownScene& scene = scene_before(torn, lines);
  const Agreement now = agreement_of(lines, newest, Pose::Identity(), scene, gates);
  if (is_known_ground(now, limits)) return true;
  if (now.known() < 0.1) torn.is_left = true;
  if (torn.is_left && now.known() >= limits.least_known && now.pierced() < limits.pierced_share)
    return true;
  consider(lines, newest, torn.line, scene);
  // The lines next to the break have seen most of what was known.
  const LineRange behind{torn.line, std::min(lines.size(), torn.line + 480)};
  const std::uint32_t first =
      std::min(end_of_fitting(lines, behind, scene, gates), lines.size() - 1);
  std::uint32_t end = first + 1;
  while (end < lines.size() && lines.seconds_between(first, end) < 0.5 * config.relocaliser.query_s)
    ++end;
  if (lines.seconds_between(first, lines.size() - 1) < config.window_s && end < lines.size())
    consider(lines, {first, end}, torn.line, scene);
  return false;
}

/// Looks for a move of a range of lines onto a scene, and says what is in doubt.
void Relocaliser::consider(const PosedLines& lines, const LineRange& range, std::uint32_t torn_from,
                           const KnownScene& scene) {
  const EstimateConfig& config = settings_.estimate;
  const AssociationGates gates = config.gates.front();
  const RelocaliserConfig& limits = config.relocaliser;
  const Agreement now = agreement_of(lines, range, Pose::Identity(), scene, gates);
  if (is_known_ground(now, limits)) return;
  const bool is_newest = range.end == lines.size();
  if (is_newest && now.pierced() >= limits.pierced_share && now.known() < 0.5)
    doubt_ = text_of(now);
  const std::vector<PlaceMove> moves = find_moves(lines, range, scene, config);
  std::fprintf(stderr, "CONSIDER %.1f range %.2f-%.2f ref <%.2f known %.2f pierced %.2f seen %.0f",
               lines.seconds_between(0, lines.size() - 1), lines.seconds_between(0, range.first),
               lines.seconds_between(0, range.end - 1), lines.seconds_between(0, torn_from),
               now.known(), now.pierced(), now.seen_m);
  for (const auto& m : moves)
    std::fprintf(stderr, " | %.2f %.2f %.1f known %.2f pierced %.2f", m.at_robot.x_m,
                 m.at_robot.y_m, to_degrees(m.at_robot.yaw_rad), m.agreement.known(),
                 m.agreement.pierced());
  std::fprintf(stderr, "\n");
  if (moves.empty()) return;
  const PlaceMove& move = moves.front();
  const double gain_m = move.agreement.evidence_m() - now.evidence_m();
  if (move.agreement.known() < limits.least_known || gain_m < limits.least_gain * now.seen_m ||
      move.agreement.pierced() > std::max(limits.pierced_share, now.pierced())) {
    return;
  }
  const Seam seam = seam_of(lines, {torn_from, range.end}, move.T_start_start, scene, gates);
  if (!is_sharp(seam, lines, range, move.T_start_start, scene, config)) return;
  const std::string evidence =
      text_of(now) + "; after " + text_of(move) + ", " + text_of(move.agreement);
  if (is_newest || doubt_.empty()) doubt_ = evidence;
  if (moves.size() > 1) {
    doubt_ += "; another move fits nearly as well";
    return;
  }
  if (find_ && find_->gain_m >= gain_m) return;
  const std::uint32_t seen = last_seen(lines, range, move.T_start_start, scene, gates);
  find_ = Find{move.T_start_start, seam, torn_from, seen, gain_m, evidence};
}

/// Returns the histories that may explain what was found, and the one without the last move.
std::vector<Relocaliser::Candidate> Relocaliser::candidates(const PosedLines& lines,
                                                            const OdometryNoise& noise) const {
  std::vector<Candidate> candidates;
  if (on_probation_ && !doubt_.empty()) candidates.push_back(*on_probation_);
  if (!find_) return candidates;
  const Pose& T = find_->T_start_start;
  const Seam& seam = find_->seam;
  if (lines.seconds_between(seam.first, seam.end) < kShortSeam_s) {
    candidates.push_back({T, seam, true, Decision::Kind::found});
    return candidates;
  }
  // What was seen in the meantime belongs to what was seen before, to what is seen now, or to both.
  candidates.push_back({T, {seam.end, seam.end}, true, Decision::Kind::found});
  candidates.push_back({T, {seam.first, seam.first}, true, Decision::Kind::found});
  const Seam way{std::max<std::uint32_t>(1, find_->last_seen), seam.end};
  if (way.first < way.end &&
      scale_of(way, T, lines) < settings_.estimate.relocaliser.drift_sigmas * noise.planar_scale) {
    candidates.push_back({T, way, false, Decision::Kind::found});
  }
  return candidates;
}

/// Makes the move of least cost, if there is one that costs less than none.
bool Relocaliser::choose(PosedLines& lines, const LineRange& range, const OdometryNoise& noise) {
  const Time now = lines.stamp(lines.size() - 1);
  if (on_probation_ && now > probation_end_) on_probation_.reset();
  const std::vector<Candidate> histories = candidates(lines, noise);
  if (histories.empty()) return false;
  const std::vector<std::uint32_t> all = context_of(lines, range, lines.size(), settings_.estimate);
  const HistoryCost before = history_cost(lines, all, settings_);
  double least = before.total - settings_.registration.min_ribbons;  // one plane less at least
  std::optional<PosedLines> best;
  const Candidate* chosen = nullptr;
  std::string figures;
  for (const Candidate& candidate : histories) {
    PosedLines history = history_with(candidate.seam, candidate.T_start_start, candidate.is_slip,
                                      lines, noise, settings_);
    const HistoryCost after = history_cost(history, all, settings_);
    std::fprintf(stderr,
                 "CHOICE %.1f gain %.0f slip %d seam %.2f-%.2f cost %zu %zu %.0f %.0f -> %zu %zu "
                 "%.0f %.0f\n",
                 lines.seconds_between(0, lines.size() - 1), find_ ? find_->gain_m : 0.0,
                 candidate.is_slip, lines.seconds_between(0, candidate.seam.first),
                 lines.seconds_between(0, candidate.seam.end), before.planes, before.unexplained,
                 before.length_m, before.total, after.planes, after.unexplained, after.length_m,
                 after.total);
    if (after.total >= least) continue;
    least = after.total;
    best = std::move(history), chosen = &candidate;
    figures = text_of(before, after);
  }
  if (chosen == nullptr) {
    if (find_ && doubt_ == find_->evidence) doubt_.clear();  // it explains less in the end
    return false;
  }
  lines = std::move(*best);
  decide(chosen->kind, lines, (find_ ? find_->evidence : doubt_) + "; " + figures);
  const Candidate back{chosen->T_start_start.inverse(Eigen::Isometry), chosen->seam, false,
                       Decision::Kind::undone};
  on_probation_.reset();
  if (chosen->kind != Decision::Kind::undone) on_probation_ = back;
  probation_end_ = now + from_seconds(settings_.estimate.relocaliser.probation_s);
  breaks_.clear();
  return true;
}

}  // namespace ribbon_mapper::slam
