// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/places/place_search.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "modeler/geometry/angles.hpp"
#include "slam/matching/scan_matcher.hpp"

namespace ribbon_mapper::slam {
namespace {

constexpr double kSpacing_m = 0.1;  // of the points that are searched for
// A match that goes farther from what was found, three cells, has slid along a wall.
constexpr double kMaxSlide_m = 0.3, kMaxSlide_rad = 0.1;
constexpr double kSame_m = 0.1, kSame_rad = 0.035;  // moves that differ by less are one

LevelPoints wall_points(const PosedLines& lines, const LineRange& range) {
  LevelPoints points;
  for (std::uint32_t i = lines.first_ribbon(range.first); i < lines.first_ribbon(range.end); ++i) {
    const PosedRibbon ribbon = lines.posed_ribbon(i);
    if (!is_of_wall(ribbon.normal)) continue;
    for (const Eigen::Vector3d& point : points_along(ribbon)) {
      points.push_back(seen_from_above(point, ribbon.normal));
    }
  }
  return points;
}

LevelPoints moved(const LevelPoints& points, const PlanarPose& T_target_source) {
  LevelPoints result;
  append_moved(points, T_target_source, result);
  return result;
}

/// Puts the better one of two moves first, and leaves out the other one if it is the same or worse.
void keep_distinct(std::vector<PlaceMove>& moves, double second_share) {
  const auto evidence_m = [](const PlaceMove& move) { return move.agreement.evidence_m(); };
  if (evidence_m(moves[1]) > evidence_m(moves[0])) std::swap(moves[0], moves[1]);
  if (is_same_move(moves[0].at_robot, moves[1].at_robot) ||
      evidence_m(moves[1]) < second_share * evidence_m(moves[0]))
    moves.pop_back();
}

}  // namespace

bool is_same_move(const PlanarPose& a, const PlanarPose& b) {
  const PlanarPose apart = relative(a, b);
  return apart.translation().norm() < kSame_m && std::abs(apart.yaw_rad) < kSame_rad;
}

bool is_same_move(const Pose& a, const Pose& b, const Pose& T_start_base) {
  const Pose T_base_start = T_start_base.inverse(Eigen::Isometry);
  return is_same_move(planar(T_base_start * a * T_start_base),
                      planar(T_base_start * b * T_start_base));
}

Pose in_space(const PlanarPose& planar) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(planar.yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.translation() << planar.x_m, planar.y_m, 0.0;
  return pose;
}

Agreement agreement_of(const PosedLines& lines, const LineRange& range, const Pose& T_start_start,
                       const KnownScene& scene, const AssociationGates& gates) {
  Agreement agreement;
  for (std::uint32_t line = range.first; line < range.end; ++line) {
    const Pose T_start_base = T_start_start * lines.T_start_base(line);
    const Eigen::Vector3d sensor = T_start_start * lines.sensor(line);
    for (std::uint32_t i = lines.first_ribbon(line); i < lines.first_ribbon(line + 1); ++i) {
      const PosedRibbon ribbon(lines.ribbon(i), T_start_base);
      if (!is_of_wall(ribbon.normal)) continue;
      const double length = ribbon.ribbon->length_m;
      agreement.seen_m += length;
      if (scene.wall_of(ribbon, gates) != nullptr) agreement.known_m += length;
      if (scene.stands_between(sensor, ribbon.centroid)) agreement.pierced_m += length;
    }
  }
  return agreement;
}

std::vector<KnownRibbon> known_ribbons(const PosedLines& lines, const LineRange& range,
                                       const Pose& T_start_start, const KnownScene& scene,
                                       const AssociationGates& gates) {
  std::vector<KnownRibbon> known;
  for (std::uint32_t i = lines.first_ribbon(range.first); i < lines.first_ribbon(range.end); ++i) {
    const PosedRibbon ribbon(lines.ribbon(i),
                             T_start_start * lines.T_start_base(lines.ribbon(i).pose));
    if (!is_of_wall(ribbon.normal)) continue;
    const KnownScene::Wall* wall = scene.wall_of(ribbon, gates);
    if (wall != nullptr) known.push_back({wall, ribbon.ribbon->length_m});
  }
  return known;
}

std::optional<Eigen::Vector2d> open_direction(const PosedLines& lines, const LineRange& range,
                                              const Pose& T_start_start, const KnownScene& scene,
                                              const EstimateSettings& settings) {
  Eigen::Matrix2d across = Eigen::Matrix2d::Zero();  // ribbons on walls across a direction
  for (const KnownRibbon& ribbon :
       known_ribbons(lines, range, T_start_start, scene, settings.estimate.gates.front())) {
    const Eigen::Vector2d normal = ribbon.wall->plane.normal().head<2>();
    across += normal * normal.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(across);
  if (axes.eigenvalues()[0] >= settings.registration.min_ribbons) return std::nullopt;
  return axes.eigenvectors().col(0);
}

PlaceSearch::PlaceSearch(const PosedLines& lines, const LineRange& range, const KnownScene& scene,
                         const EstimateSettings& settings)
    : lines_(lines),
      range_(range),
      scene_(scene),
      settings_(settings),
      here_(planar(lines.T_start_base(range.end - 1))),
      seen_(thinned(wall_points(lines, range), kSpacing_m)),
      known_(thinned(scene.points(), 0.5 * kSpacing_m)),
      search_(known_) {}

std::vector<PlaceMove> PlaceSearch::moves_about(std::uint32_t pivot_line, double radius_m) const {
  const RelocaliserConfig& limits = settings_.estimate.relocaliser;
  const PlanarPose pivot = planar(lines_.T_start_base(pivot_line));
  const auto found =
      search_.find(moved(seen_, inverse(pivot)), pivot,
                   {radius_m, limits.angle_deg * kDegree, limits.least_score}, limits.second_share);
  if (!found) return {};
  const SurfaceMap surfaces(known_);
  std::vector<PlaceMove> moves;
  const auto add = [&](const PlanarPose& moved_pivot) {
    const double most =
        std::max(std::abs(moved_pivot.x_m - pivot.x_m), std::abs(moved_pivot.y_m - pivot.y_m));
    if (most > radius_m - kSame_m) return;  // the peak may lie outside
    const auto move = move_to(moved_pivot * relative(pivot, here_), surfaces);
    if (move) moves.push_back(*move);
  };
  add(found->T_map_base);
  if (found->second_score > 0.0) add(found->T_map_base_second);
  if (moves.size() == 2) keep_distinct(moves, limits.second_share);
  return moves;
}

/// Returns the move that takes the newest line near a guess, matched to the surfaces of the scene;
/// nothing if the match slides away from it. Along a bare wall, only its ends hold a match, and
/// they are where it was not seen any farther: there, the line stays where it is.
std::optional<PlaceMove> PlaceSearch::move_to(const PlanarPose& guess,
                                              const SurfaceMap& surfaces) const {
  const LevelPoints points = moved(seen_, inverse(here_));
  PlanarPose there = match(points, surfaces, guess, std::nullopt, MatchConfig{}).T_map_base;
  const PlanarPose slid = relative(guess, there);
  if (slid.translation().norm() > kMaxSlide_m || std::abs(slid.yaw_rad) > kMaxSlide_rad) {
    return std::nullopt;
  }
  const auto T_start_start = [&] { return in_space(there * inverse(here_)); };
  if (const auto open = open_direction(lines_, range_, T_start_start(), scene_, settings_)) {
    const double along_m = open->dot(there.translation() - here_.translation());
    there.x_m -= along_m * open->x();
    there.y_m -= along_m * open->y();
  }
  return PlaceMove{
      T_start_start(), relative(here_, there),
      agreement_of(lines_, range_, T_start_start(), scene_, settings_.estimate.gates.front())};
}

}  // namespace ribbon_mapper::slam
