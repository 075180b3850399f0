// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/floor_plan/plan_walls.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "modeler/floor_plan/face_pairs.hpp"
#include "modeler/polygon/polygon_operations.hpp"

namespace ribbon_mapper {
namespace {

/// Returns the point of a line that is straight behind a point of another one.
Eigen::Vector2d behind(const Eigen::Vector2d& point, const WallFace& face) {
  return face.at(face.along_m(point));
}

Eigen::AlignedBox2d box_of(const Ring& ring) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : ring) box.extend(point);
  return box;
}

PlanWall wall_of(const FacePair& pair, const std::vector<WallFace>& faces) {
  const WallFace &front = faces[pair.front], &back = faces[pair.back];
  PlanWall wall;
  wall.planes = {front.plane, back.plane};
  wall.face = {front.at(pair.piece.begin), front.at(pair.piece.end)};
  wall.normal = front.normal;
  wall.thickness_m = front.depth_m(behind(front.at(pair.piece.middle()), back));
  // Seen along the normal, the line runs to the left: its back lies on the left of its direction.
  wall.footprint = {
      {{wall.face[0], wall.face[1], behind(wall.face[1], back), behind(wall.face[0], back)}, {}}};
  return wall;
}

/// Removes what is narrower than 2 mm.
Polygons without_slivers(const Polygons& polygons) {
  constexpr double kHalf_m = 0.001;
  if (polygons.empty()) return polygons;
  const Polygons core = grown(polygons, -kHalf_m);
  return core.empty() ? core : grown(core, kHalf_m);
}

/// Removes from each footprint what lies in one before it: at corners.
void part(std::vector<PlanWall>& walls) {
  std::vector<Eigen::AlignedBox2d> boxes;
  std::vector<Polygons> whole;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    whole.push_back(walls[i].footprint);
    boxes.push_back(box_of(walls[i].footprint.front().outer));
    for (std::size_t k = 0; k < i; ++k) {
      if (boxes[k].intersects(boxes[i])) {
        walls[i].footprint = difference(walls[i].footprint, whole[k]);
      }
    }
    walls[i].footprint = without_slivers(walls[i].footprint);
  }
  walls.erase(std::remove_if(walls.begin(), walls.end(),
                             [](const PlanWall& wall) { return wall.footprint.empty(); }),
              walls.end());
}

/// Returns true if a piece of a face is the end of a wall that has two faces.
bool is_end_of(const Polygons& solid, const WallFace& face, const Interval& piece,
               const FloorPlanConfig& config) {
  if (piece.length() > config.greatest_thickness_m) return false;
  for (const double along_m : {piece.begin, piece.middle(), piece.end}) {
    if (distance(solid, face.at(along_m)) > config.joint_m) return false;
  }
  return true;
}

}  // namespace

std::vector<PlanWall> plan_walls(const std::vector<WallFace>& faces,
                                 const FloorPlanConfig& config) {
  const FacePairs pairs = pairs_of(faces, config);
  std::vector<PlanWall> walls;
  for (const FacePair& pair : pairs.pairs) walls.push_back(wall_of(pair, faces));
  part(walls);
  const Polygons solid = solid_of(walls, config);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const Interval& piece : pairs.unpaired[i]) {
      if (piece.length() < config.least_length_m) continue;
      if (is_end_of(solid, faces[i], piece, config)) continue;
      PlanWall& wall = walls.emplace_back();
      wall.planes = {faces[i].plane};
      wall.face = {faces[i].at(piece.begin), faces[i].at(piece.end)};
      wall.normal = faces[i].normal;
    }
  }
  return walls;
}

Polygons solid_of(const std::vector<PlanWall>& walls, const FloorPlanConfig& config) {
  Polygons all;
  for (const PlanWall& wall : walls) {
    all.insert(all.end(), wall.footprint.begin(), wall.footprint.end());
  }
  if (all.empty()) return all;
  const double half_m = 0.5 * config.joint_m;
  return simplified(grown(grown(all, half_m), -half_m), 1e-3);
}

}  // namespace ribbon_mapper
