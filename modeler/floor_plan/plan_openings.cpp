// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/floor_plan/plan_openings.hpp"

#include <algorithm>
#include <cmath>

#include "modeler/floor_plan/face_pairs.hpp"
#include "modeler/geometry/angles.hpp"

namespace ribbon_mapper {
namespace {

constexpr double kAcrossCosine = 0.17;  // within 10 degrees of a right angle
constexpr double kJambReach_m = 0.25;   // of a jamb from where stray cells put it
constexpr double kSameShare = 0.5;      // of the narrower one, where two gaps are one opening

/// A gap in one face.
struct Gap {
  const WallFace* face;
  Interval piece;
  const DoorOpening* door;  // null: wider than a door
};

/// Gaps that are one opening.
using GapGroup = std::vector<Gap>;

const WallFace* face_of_plane(std::int64_t plane, const std::vector<WallFace>& faces) {
  const auto found = std::find_if(faces.begin(), faces.end(),
                                  [&](const WallFace& face) { return face.plane == plane; });
  return found == faces.end() ? nullptr : &*found;
}

/// Returns the gaps in all faces, those of doors first.
std::vector<Gap> gaps_in(const std::vector<WallFace>& faces, const Semantics& semantics) {
  std::vector<Gap> gaps;
  for (const DoorOpening& door : semantics.openings) {
    const WallFace* face = face_of_plane(door.plane, faces);
    if (face == nullptr) continue;
    const double a_m = face->along_m(door.jambs[0].head<2>());
    const double b_m = face->along_m(door.jambs[1].head<2>());
    gaps.push_back({face, {std::min(a_m, b_m), std::max(a_m, b_m)}, &door});
  }
  for (const WallFace& face : faces) {
    for (const Interval& piece : face.open) gaps.push_back({&face, piece, nullptr});
  }
  return gaps;
}

bool are_parallel(const WallFace& a, const WallFace& b, const FloorPlanConfig& config) {
  return std::abs(a.normal.dot(b.normal)) >= std::cos(config.parallel_deg * kDegree);
}

/// Returns true if two gaps are one opening, on the same face of a wall or on both.
bool is_same_opening(const Gap& a, const Gap& b, const FloorPlanConfig& config) {
  if (!are_parallel(*a.face, *b.face, config)) return false;
  const double depth_m = a.face->depth_m(b.face->at(b.piece.middle()));
  const bool is_back = a.face->normal.dot(b.face->normal) < 0.0;
  if (is_back ? depth_m <= 0.0 || depth_m > config.greatest_thickness_m
              : std::abs(depth_m) > config.joint_m) {
    return false;
  }
  const Interval other = on_face(*a.face, *b.face, b.piece);
  const double both_m = std::min(a.piece.end, other.end) - std::max(a.piece.begin, other.begin);
  return both_m >= kSameShare * std::min(a.piece.length(), other.length());
}

std::vector<GapGroup> grouped(const std::vector<Gap>& gaps, const FloorPlanConfig& config) {
  std::vector<GapGroup> groups;
  for (const Gap& gap : gaps) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const GapGroup& other) {
      return is_same_opening(other.front(), gap, config);
    });
    if (group == groups.end()) {
      groups.push_back({gap});
    } else {
      group->push_back(gap);
    }
  }
  return groups;
}

/// Returns how far the other face of the wall is behind the face of a gap, if it was seen beside
/// it.
std::optional<double> depth_at(const Gap& gap, const std::vector<WallFace>& faces,
                               const FloorPlanConfig& config) {
  std::optional<double> least_m;
  for (const WallFace& face : faces) {
    if (!are_parallel(*gap.face, face, config) || gap.face->normal.dot(face.normal) > 0.0) continue;
    const Interval piece = on_face(face, *gap.face, gap.piece);
    const double depth_m = gap.face->depth_m(face.at(piece.middle()));
    if (depth_m < config.least_thickness_m || depth_m > config.greatest_thickness_m) continue;
    const Interval around{piece.begin - config.joint_m, piece.end + config.joint_m};
    if (intersection(face.seen, {around}).empty()) continue;
    if (!least_m || depth_m < *least_m) least_m = depth_m;
  }
  return least_m;
}

/// The mean of positions, or what stands for it if there are none.
class Mean {
 public:
  void add(double value) {
    sum_ += value;
    ++count_;
  }
  double or_else(double other) const { return count_ > 0 ? sum_ / count_ : other; }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

/// Returns the mean of the ends of the gaps, along the first face.
Interval mean_piece(const GapGroup& group) {
  Mean begin, end;
  for (const Gap& gap : group) {
    const Interval piece = on_face(*group.front().face, *gap.face, gap.piece);
    begin.add(piece.begin);
    end.add(piece.end);
  }
  return {begin.or_else(0.0), end.or_else(0.0)};
}

/// Returns an opening between the solid pieces beside it, in all faces of its wall. A cell at a
/// jamb is seen whole, though the wall fills half of it in the mean.
Interval between_solid(const WallFace& wall, const Interval& piece,
                       const std::vector<WallFace>& faces, const FloorPlanConfig& config) {
  Mean begin, end;
  for (const WallFace& face : faces) {
    if (!are_parallel(wall, face, config)) continue;
    const double depth_m = wall.depth_m(face.at(face.along_m(wall.at(piece.middle()))));
    if (depth_m < -config.joint_m || depth_m > config.greatest_thickness_m) continue;
    for (const Interval& own : face.solid) {
      const Interval solid = on_face(wall, face, own);
      const double begin_m = solid.end - 0.5 * face.cell_m, end_m = solid.begin + 0.5 * face.cell_m;
      if (std::abs(begin_m - piece.begin) <= kJambReach_m) begin.add(begin_m);
      if (std::abs(end_m - piece.end) <= kJambReach_m) end.add(end_m);
    }
  }
  return {begin.or_else(piece.begin), end.or_else(piece.end)};
}

/// Returns whether a face is the reveal at a jamb: across the wall, no deeper than it, turned to
/// the opening.
bool is_reveal_at(const WallFace& reveal, const WallFace& wall, double jamb_m, double side,
                  double depth_m, const FloorPlanConfig& config) {
  if (reveal.seen.empty() || side * reveal.normal.dot(wall.along()) > -1.0 + kAcrossCosine) {
    return false;
  }
  const Interval whole{reveal.seen.front().begin, reveal.seen.back().end};
  const Eigen::Vector2d middle = reveal.at(whole.middle());
  const double middle_m = wall.depth_m(middle);
  return whole.length() <= depth_m + 2.0 * config.joint_m && middle_m > 0.0 && middle_m < depth_m &&
         std::abs(wall.along_m(middle) - jamb_m) <= config.joint_m;
}

/// Moves a jamb to the reveals there, and notes their planes.
void fit_jamb(double& jamb_m, double side, const WallFace& wall, const std::vector<WallFace>& faces,
              const FloorPlanConfig& config, PlanOpening& opening) {
  Mean mean;
  const double depth_m = opening.depth_m.value_or(config.greatest_thickness_m);
  for (const WallFace& face : faces) {
    if (!is_reveal_at(face, wall, jamb_m, side, depth_m, config)) continue;
    mean.add(wall.along_m(face.at(face.seen.front().middle())));
    opening.planes.push_back(face.plane);
  }
  jamb_m = mean.or_else(jamb_m);
}

PlanOpening opening_of(const GapGroup& group, const std::vector<WallFace>& faces,
                       const FloorPlanConfig& config) {
  const WallFace& face = *group.front().face;
  PlanOpening opening;
  opening.normal = face.normal;
  for (const Gap& gap : group) {
    opening.planes.push_back(gap.face->plane);
    if (gap.door == nullptr) continue;
    opening.sill_m = gap.door->sill_m;
    if (!opening.head_m) opening.head_m = gap.door->head_m;
  }
  opening.depth_m = depth_at(group.front(), faces, config);
  Interval piece = between_solid(face, mean_piece(group), faces, config);
  fit_jamb(piece.begin, -1.0, face, faces, config, opening);
  fit_jamb(piece.end, 1.0, face, faces, config, opening);
  const Eigen::Vector2d to_middle = -0.5 * opening.depth_m.value_or(0.0) * face.normal;
  opening.jambs = {face.at(piece.begin) + to_middle, face.at(piece.end) + to_middle};
  std::sort(opening.planes.begin(), opening.planes.end());
  opening.planes.erase(std::unique(opening.planes.begin(), opening.planes.end()),
                       opening.planes.end());
  return opening;
}

/// Removes from a face what lies in an opening.
void cut(const PlanOpening& opening, const FloorPlanConfig& config, WallFace& face) {
  if (std::abs(face.normal.dot(opening.normal)) < std::cos(config.parallel_deg * kDegree)) return;
  const Eigen::Vector2d middle = opening.middle();
  const double ahead_m = opening.normal.dot(face.at(face.along_m(middle)) - middle);
  const double half_m = 0.5 * opening.depth_m.value_or(0.0) + config.joint_m;
  if (ahead_m > half_m) return;
  if (ahead_m < (opening.depth_m ? -half_m : -config.greatest_thickness_m)) return;
  const double a_m = face.along_m(opening.jambs[0]), b_m = face.along_m(opening.jambs[1]);
  face.seen = difference(face.seen, Interval{std::min(a_m, b_m), std::max(a_m, b_m)});
}

/// Returns true if the opening's planes name the face, but it is across the wall.
bool is_reveal_of(const PlanOpening& opening, const WallFace& face) {
  return std::abs(face.normal.dot(opening.normal)) < 0.5 &&
         std::binary_search(opening.planes.begin(), opening.planes.end(), face.plane);
}

}  // namespace

std::vector<PlanOpening> plan_openings(const std::vector<Plane>& planes, const Semantics& semantics,
                                       std::vector<WallFace>& faces,
                                       const FloorPlanConfig& config) {
  std::vector<PlanOpening> openings;
  for (const GapGroup& group : grouped(gaps_in(faces, semantics), config)) {
    openings.push_back(opening_of(group, faces, config));
  }
  hang_leaves(planes, semantics, config, openings);
  for (const PlanOpening& opening : openings) {
    faces.erase(std::remove_if(faces.begin(), faces.end(),
                               [&](const WallFace& face) { return is_reveal_of(opening, face); }),
                faces.end());
    for (WallFace& face : faces) cut(opening, config, face);
  }
  return openings;
}

}  // namespace ribbon_mapper
