// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/places/slip_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ribbon_mapper::slam {
namespace {

constexpr double kSlip_s = 1.0;        // half of a push
constexpr double kNear_s = 6.0;        // two places within it are compared by the same lines
constexpr std::size_t kMostSlips = 2;  // each costs an adjustment

/// How far some lines fit known walls.
struct Comparison {
  Agreement here, moved;  // where the lines are, and if they are moved
  double ribbon_m = 1.0;  // mean length of their ribbons

  /// Returns how many more ribbons fit if moved.
  double gain() const { return (moved.evidence_m() - here.evidence_m()) / ribbon_m; }
  /// Returns what they say of a slip. If most of what does not fit stays so, it is new ground that
  /// happens to be like what is known.
  SlipEvidence evidence(const EstimateSettings& settings) const {
    const double least = settings.registration.min_ribbons;
    return {std::abs(gain()) < least ? 0.0 : gain(),
            gain() >= least && moved.known() >= settings.estimate.relocaliser.least_known &&
                1.0 - moved.known() <= 0.5 * (1.0 - here.known()),
            gain() <= -least && moved.evidence_m() < 0.5 * here.evidence_m()};
  }
};

std::vector<std::uint32_t> indices_of(const LineRange& range) {
  std::vector<std::uint32_t> indices(range.end - range.first);
  std::iota(indices.begin(), indices.end(), range.first);
  return indices;
}

/// Where a robot may have slipped, and what is seen around it.
class Place {
 public:
  Place(std::uint32_t line, const PosedLines& lines, const EstimateSettings& settings)
      : lines_(lines), settings_(settings), line_(line) {
    const std::uint32_t first = lines_within(kSlip_s, lines, line, lines.size()).end;
    behind_ = lines_within(0.5 * query_s(), lines, first, lines.size());
  }

  /// Returns true if more lines behind the place are to come.
  bool is_new() const { return behind_.end == lines_.size(); }

  /// Compares the lines behind the place with what was seen before it, where they are and moved.
  Comparison compared(const Pose& T_start_start) const {
    const KnownScene scene(lines_, indices_of(lines_before(query_s(), lines_, line_)), settings_);
    return {agreement_with(scene, Pose::Identity()), agreement_with(scene, T_start_start),
            ribbon_m()};
  }

  /// Returns the seam at the place, by what is seen on both sides of it. The slip may have begun
  /// before it.
  Seam seam(const Pose& T_start_start) const {
    const std::uint32_t first =
        std::max<std::uint32_t>(1, lines_before(2.0 * kSlip_s, lines_, line_).first);
    PosedLines joined = lines_;
    move_behind({behind_.first, behind_.first}, T_start_start, joined);
    std::vector<std::uint32_t> sides = indices_of(lines_before(query_s(), lines_, first));
    for (const std::uint32_t i : indices_of(behind_)) sides.push_back(i);
    const KnownScene scene(joined, sides, settings_);
    return parting_of(lines_, {first, behind_.first}, T_start_start, scene, gates());
  }

 private:
  const AssociationGates& gates() const { return settings_.estimate.gates.front(); }
  double query_s() const { return settings_.estimate.relocaliser.query_s; }
  Agreement agreement_with(const KnownScene& scene, const Pose& T_start_start) const {
    return agreement_of(lines_, behind_, T_start_start, scene, gates());
  }
  /// Returns the mean length of the ribbons behind the place.
  double ribbon_m() const {
    const std::uint32_t first = lines_.first_ribbon(behind_.first),
                        end = lines_.first_ribbon(behind_.end);
    double length_m = 0.0;
    for (std::uint32_t i = first; i < end; ++i) length_m += lines_.ribbon(i).length_m;
    return end > first ? length_m / (end - first) : 1.0;
  }

  const PosedLines& lines_;
  const EstimateSettings& settings_;
  std::uint32_t line_;
  LineRange behind_;
};

/// A line at which a slip fits.
struct FittingLine {
  std::uint32_t line;
  Comparison compared;
};

/// Enters a line among the best of others, which are ordered. Of lines that are close together,
/// only the best one stays.
void enter(const FittingLine& fitting, const PosedLines& lines, std::vector<FittingLine>& best) {
  const double gain = fitting.compared.gain();
  const auto is_near = [&](const FittingLine& other) {
    return std::abs(lines.seconds_between(other.line, fitting.line)) < kNear_s;
  };
  const auto near = std::find_if(best.begin(), best.end(), is_near);
  if (near != best.end() && near->compared.gain() >= gain) return;
  best.erase(std::remove_if(best.begin(), best.end(), is_near), best.end());
  const auto next = std::find_if(best.begin(), best.end(), [&](const FittingLine& other) {
    return other.compared.gain() < gain;
  });
  best.insert(next, fitting);
  if (best.size() > kMostSlips) best.pop_back();
}

}  // namespace

SlipEvidence slip_evidence(const PosedLines& lines, std::uint32_t line, const Pose& T_start_start,
                           const EstimateSettings& settings) {
  return Place(line, lines, settings).compared(T_start_start).evidence(settings);
}

std::vector<FittingSlip> fitting_slips(const PosedLines& lines, const LineRange& range,
                                       const Pose& T_start_start,
                                       const EstimateSettings& settings) {
  std::vector<FittingLine> best;
  for (std::uint32_t i = range.first; i < range.end;
       i = lines_within(kSlip_s, lines, i, range.end).end) {
    const Place place(i, lines, settings);
    if (place.is_new()) break;
    const Comparison compared = place.compared(T_start_start);
    if (compared.gain() >= settings.registration.min_ribbons) enter({i, compared}, lines, best);
  }
  std::vector<FittingSlip> slips;
  for (const FittingLine& fitting : best) {
    slips.push_back({Place(fitting.line, lines, settings).seam(T_start_start),
                     fitting.compared.evidence(settings)});
  }
  return slips;
}

}  // namespace ribbon_mapper::slam
