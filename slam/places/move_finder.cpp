// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/places/move_finder.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

#include "modeler/geometry/angles.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr std::size_t kMostBreaks = 6;  // each costs a search
constexpr double kSameScene_m = 2.0;    // a quarter of the context's radius
constexpr double kNothing = 0.1;        // share of known walls that may be chance

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

/// Returns true if lines are on known ground after a move, and clearly more than before it.
bool is_clear_gain(const Agreement& before, const Agreement& after, double least_known,
                   const RelocaliserConfig& config) {
  return after.known() >= least_known &&
         after.evidence_m() - before.evidence_m() >= config.least_gain * after.seen_m;
}

/// Returns true if a move is to be preferred to another one.
bool is_better(const FoundMove& move, const FoundMove& other) {
  if (move.is_partial != other.is_partial) return other.is_partial;
  return move.gain_m > other.gain_m;
}

}  // namespace

Agreement MoveFinder::agreement(const PosedLines& lines, const LineRange& range,
                                const Pose& T_start_start, const KnownScene& scene) const {
  return agreement_of(lines, range, T_start_start, scene, settings_.estimate.gates.front());
}

Finding MoveFinder::find(const PosedLines& lines, double tracked_share, double max_scale) {
  finding_ = {};
  found_before_ = std::exchange(found_, {});
  max_scale_ = max_scale;
  const LineRange newest = newest_within(lines, settings_.estimate.relocaliser.query_s);
  if (newest.first < 2) return finding_;
  look_at_recent(lines, newest, tracked_share);
  for (std::size_t i = breaks_.size(); i-- > 0;) {
    if (!search_before(breaks_[i], lines, newest)) continue;
    breaks_.resize(i);  // later ones lie on ground that is right as well
    break;
  }
  return finding_;
}

/// Compares the newest lines with all older ones if they show unknown walls. Opens a break there.
void MoveFinder::look_at_recent(const PosedLines& lines, const LineRange& newest,
                                double tracked_share) {
  const RelocaliserConfig& config = settings_.estimate.relocaliser;
  const Time now = lines.stamp(lines.size() - 1);
  if (tracked_share < config.known_share) doubted_until_ = now + from_seconds(config.query_s);
  if (now >= doubted_until_) {
    if (!breaks_.empty()) breaks_.back().is_settled = true;
    return;
  }
  const KnownScene scene(lines, context_of(lines, newest, newest.first, settings_.estimate),
                         settings_);
  const Agreement unmoved = agreement(lines, newest, Pose::Identity(), scene);
  open_break(lines, newest, unmoved, scene);
  const bool is_asked_for_break =
      breaks_.empty() || breaks_.back().line >= newest.first || breaks_.back().tear.has_value();
  if (!is_asked_for_break) {
    ask({newest, newest.first, unmoved, std::nullopt}, lines, scene);
  }
}

/// Opens a break where known ground ends, by what older lines know of the newest ones; on new
/// ground, where these contradict them.
void MoveFinder::open_break(const PosedLines& lines, const LineRange& newest, const Agreement& now,
                            const KnownScene& scene) {
  const RelocaliserConfig& config = settings_.estimate.relocaliser;
  const bool is_known = is_known_ground(now, config);
  const bool is_contradicted = is_contradiction(now, config);
  if (is_known && !breaks_.empty()) breaks_.back().is_settled = true;
  if (is_known) return;
  std::optional<std::uint32_t> strained;  // a contradiction by known walls tells where by itself
  if (!is_contradicted) strained = newly_strained(lines);
  if (!strained && !breaks_.empty() && !breaks_.back().is_settled) {
    if (!is_contradicted || breaks_.back().tear) return;
  }
  if (breaks_.size() == kMostBreaks) {
    const auto plain = std::find_if(breaks_.begin(), breaks_.end(),
                                    [](const Break& b) { return !b.tear.has_value(); });
    breaks_.erase(plain != breaks_.end() ? plain : breaks_.begin());
  }
  const std::uint32_t line = strained.value_or(newest.first);
  const auto next =
      std::find_if(breaks_.begin(), breaks_.end(), [&](const Break& b) { return b.line > line; });
  Break& torn = *breaks_.insert(next, Break{});
  torn.line = line;
  if (is_contradicted) {
    torn.tear = end_of_fitting(lines, newest, scene, settings_.estimate.gates.front());
  }
}

/// Returns where the window contradicts its odometry, unless a break begins there already.
std::optional<std::uint32_t> MoveFinder::newly_strained(const PosedLines& lines) const {
  const LineRange window = newest_within(lines, settings_.estimate.window_s);
  const std::optional<std::uint32_t> line = most_strained(lines, window, max_scale_);
  if (!line) return std::nullopt;
  const bool is_broken = std::any_of(breaks_.begin(), breaks_.end(), [&](const Break& torn) {
    return std::abs(lines.seconds_between(*line, torn.line)) < settings_.estimate.window_step_s;
  });
  return is_broken ? std::nullopt : line;
}

std::optional<std::uint32_t> MoveFinder::last_tear_before(std::uint32_t line) const {
  const auto torn = std::find_if(breaks_.rbegin(), breaks_.rend(),
                                 [&](const Break& b) { return b.tear && *b.tear < line; });
  return torn != breaks_.rend() ? torn->tear : std::nullopt;
}

/// Returns how far the newest line may be from where it seems to be after a way that began at a
/// line. Walls that are turned by less than the gates are taken for others, and nothing tells; on a
/// way that leads back, such a turn was at most half of it away.
double MoveFinder::radius_m(std::uint32_t line, const PosedLines& lines) const {
  const double turn_rad = settings_.estimate.gates.front().angle_deg * kDegree;
  return std::max(settings_.estimate.relocaliser.radius_m,
                  0.5 * way_since(line, lines) * std::sin(turn_rad));
}

/// Returns how much farther than after a slip the newest line may be from where it seems to be. One
/// at the tear has taken it farther.
double MoveFinder::reach_m(const Break& torn, const PosedLines& lines) const {
  if (!torn.tear) return radius_m(torn.line, lines) - settings_.estimate.relocaliser.radius_m;
  const Eigen::Vector3d from = lines.T_start_base(*torn.tear).translation(),
                        to = lines.T_start_base(lines.size() - 1).translation();
  const double angle_rad = settings_.estimate.relocaliser.angle_deg * kDegree;
  return 2.0 * std::sin(0.5 * angle_rad) * (to - from).norm();
}

/// Returns what was known before a break near the newest line, or where a slip would put it.
const KnownScene& MoveFinder::scene_before(Break& torn, const PosedLines& lines) const {
  const EstimateConfig& config = settings_.estimate;
  const std::uint32_t last = lines.size() - 1;
  const Eigen::Vector3d here = lines.T_start_base(last).translation();
  // Poses hardly change any more when they have left the window.
  const bool is_final = lines.seconds_between(torn.line, last) > 2.0 * config.window_s;
  if (!is_final || !torn.scene || (here - torn.centre).norm() > kSameScene_m) {
    torn.scene.emplace(lines,
                       lines_near({here}, config.context_radius_m + reach_m(torn, lines), lines,
                                  torn.line, config),
                       settings_);
    torn.centre = here;
  }
  return *torn.scene;
}

/// Searches for lines behind a break on what was known before it. Returns true if the break is to
/// be closed.
bool MoveFinder::search_before(Break& torn, const PosedLines& lines, const LineRange& newest) {
  const RelocaliserConfig& config = settings_.estimate.relocaliser;
  const LineRange range{std::max(newest.first, torn.line), newest.end};
  const KnownScene& scene = scene_before(torn, lines);
  const Agreement now = agreement(lines, range, Pose::Identity(), scene);
  if (now.known() < kNothing) torn.is_left = true;
  const bool is_back =
      torn.is_left && now.known() >= config.least_known && now.pierced() < config.pierced_share;
  if (is_back || is_known_ground(now, config)) return true;
  ask({range, torn.line, now, torn.tear}, lines, scene);
  if (const auto behind = range_behind(torn, lines, scene)) {
    ask({*behind, torn.line, agreement(lines, *behind, Pose::Identity(), scene), torn.tear}, lines,
        scene);
  }
  return false;
}

/// Returns the lines just behind a break, which have seen most of what was known before it; nothing
/// if they are too few yet, or were asked for before.
std::optional<LineRange> MoveFinder::range_behind(const Break& torn, const PosedLines& lines,
                                                  const KnownScene& scene) const {
  const EstimateConfig& config = settings_.estimate;
  if (lines.seconds_between(torn.line, lines.size() - 1) >= 2.0 * config.window_s) {
    return std::nullopt;
  }
  const LineRange around = lines_within(config.window_s, lines, torn.line, lines.size());
  const std::uint32_t first = end_of_fitting(lines, around, scene, config.gates.front());
  const LineRange behind =
      lines_within(0.5 * config.relocaliser.query_s, lines, first, lines.size());
  if (behind.end >= lines.size()) return std::nullopt;
  if (lines.seconds_between(first, lines.size() - 1) >= config.window_s) return std::nullopt;
  return behind;
}

/// Asks whether lines fit a scene better if they are moved.
void MoveFinder::ask(const Question& question, const PosedLines& lines, const KnownScene& scene) {
  const RelocaliserConfig& config = settings_.estimate.relocaliser;
  const Agreement& now = question.unmoved;
  if (is_known_ground(now, config)) return;
  if (question.range.end == lines.size() && is_contradiction(now, config)) {
    finding_.doubt = text_of(now);
  }
  const PlaceSearch search(lines, question.range, scene, settings_);
  const double radius = radius_m(question.torn_from, lines);
  const auto search_about = [&](std::uint32_t pivot_line) {
    std::vector<PlaceMove> moves = search.moves_about(pivot_line, radius);
    for (const PlaceMove& move : moves) {
      if (is_clear_gain(now, move.agreement, config.least_known_again, config))
        found_.push_back(move.T_start_start);
    }
    tell_apart(moves, lines);
    if (!moves.empty()) judge(question, moves, lines, scene);
  };
  search_about(question.range.end - 1);
  // A slip a long way back has moved the newest lines farther than the window is wide.
  if (question.tear || is_contradiction(now, config)) {
    search_about(question.tear.value_or(question.torn_from));
  }
}

bool MoveFinder::was_found_before(const PlaceMove& move, const PosedLines& lines) const {
  const Pose T_start_base = lines.T_start_base(lines.size() - 1);
  return std::any_of(found_before_.begin(), found_before_.end(), [&](const Pose& before) {
    return is_same_move(before, move.T_start_start, T_start_base);
  });
}

/// Leaves out the one of two moves that the look before has not found, if it has found the other.
void MoveFinder::tell_apart(std::vector<PlaceMove>& moves, const PosedLines& lines) const {
  if (moves.size() < 2) return;
  const bool is_first_known = was_found_before(moves[0], lines);
  if (is_first_known == was_found_before(moves[1], lines)) return;
  moves.erase(is_first_known ? moves.begin() + 1 : moves.begin());
}

/// Returns true if a move would put the newest lines where known walls stand before what they see.
bool MoveFinder::contradicts_newest(const Pose& T_start_start, const PosedLines& lines,
                                    const KnownScene& scene) const {
  const RelocaliserConfig& config = settings_.estimate.relocaliser;
  const LineRange newest = newest_within(lines, config.query_s);
  const Agreement here = agreement(lines, newest, Pose::Identity(), scene);
  return agreement(lines, newest, T_start_start, scene).pierced() >
         std::max(config.pierced_share, here.pierced());
}

void MoveFinder::judge(const Question& question, const std::vector<PlaceMove>& moves,
                       const PosedLines& lines, const KnownScene& scene) {
  const Agreement& now = question.unmoved;
  const RelocaliserConfig& config = settings_.estimate.relocaliser;
  const AssociationGates& gates = settings_.estimate.gates.front();
  const PlaceMove& move = moves.front();
  const Agreement& moved = move.agreement;
  // Where a robot has lost its way, most of what it sees may be new.
  const double least =
      was_found_before(move, lines) ? config.least_known_again : config.least_known;
  if (!is_clear_gain(now, moved, least, config)) return;
  if (moved.pierced() > std::max(config.pierced_share, now.pierced())) return;
  if (contradicts_newest(move.T_start_start, lines, scene)) return;
  const Seam seam =
      seam_of(lines, {question.torn_from, question.range.end}, move.T_start_start, scene, gates);
  const LineRange behind = lines_within(0.5 * config.query_s, lines, seam.end, question.range.end);
  if (behind.first == behind.end ||
      !is_clear_gain(agreement(lines, behind, Pose::Identity(), scene),
                     agreement(lines, behind, move.T_start_start, scene), least, config)) {
    return;  // it is no tear: the lines behind it fit where they are
  }
  finding_.doubt = text_of(now) + "; after " + text_of(move) + ", " + text_of(moved);
  if (moves.size() > 1) {
    finding_.doubt += "; another move fits nearly as well";
    return;
  }
  FoundMove found{move.T_start_start,
                  seam,
                  last_seen(lines, question.range, move.T_start_start, scene, gates),
                  moved.evidence_m() - now.evidence_m(),
                  moved.known() < config.least_known,
                  question.tear || is_contradiction(now, config),
                  now.pierced_m - moved.pierced_m,
                  last_tear_before(seam.first),
                  finding_.doubt};
  if (!finding_.move || is_better(found, *finding_.move)) finding_.move = std::move(found);
}

}  // namespace ribbon_mapper::slam
