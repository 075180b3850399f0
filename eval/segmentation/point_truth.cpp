// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/segmentation/point_truth.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "eval/metrics/statistics.hpp"
#include "modeler/geometry/angles.hpp"

namespace ribbon_mapper::eval {
namespace {

constexpr int kNoRibbon = Overlaps::kNoRegion - 1;

/// Returns the index of the plane that each ribbon belongs to.
std::vector<int> ribbon_labels(std::size_t ribbons, const std::vector<Plane>& planes) {
  std::vector<int> labels(ribbons, Overlaps::kNoRegion);
  for (std::size_t plane = 0; plane < planes.size(); ++plane) {
    for (const std::uint32_t ribbon : planes[plane].ribbons) {
      labels[ribbon] = static_cast<int>(plane);
    }
  }
  return labels;
}

}  // namespace

void PointTruth::add(Time middle_of_line, std::vector<int> cells) {
  lines_.push_back({middle_of_line, std::move(cells)});
}

void PointTruth::settle(const std::vector<sim::TruthPlane>& planes) {
  std::vector<int> plane_of_cell;
  for (std::size_t plane = 0; plane < planes.size(); ++plane) {
    for (const int cell : planes[plane].cell_numbers) {
      const auto index = static_cast<std::size_t>(cell);
      if (index >= plane_of_cell.size()) plane_of_cell.resize(index + 1, Overlaps::kNoRegion);
      plane_of_cell[index] = static_cast<int>(plane);
    }
  }
  for (Line& line : lines_) {
    for (int& label : line.labels) {
      const bool is_known = label >= 0 && static_cast<std::size_t>(label) < plane_of_cell.size();
      label = is_known ? plane_of_cell[static_cast<std::size_t>(label)] : Overlaps::kNoRegion;
    }
  }
  planes_ = planes;
}

const PointTruth::Line* PointTruth::line_at(Time middle) const {
  const auto found =
      std::lower_bound(lines_.begin(), lines_.end(), middle,
                       [](const Line& line, Time time) { return line.middle < time; });
  return found != lines_.end() && found->middle == middle ? &*found : nullptr;
}

Overlaps PointTruth::overlaps(const Modeler& modeler, const std::vector<Plane>& planes,
                              Points which) const {
  const std::vector<int> plane_of_ribbon = ribbon_labels(modeler.ribbons().size(), planes);
  Overlaps overlaps(planes_.size(), planes.size());
  auto ribbon = modeler.ribbons().begin();  // sorted by their poses
  const std::vector<StampedPose> trajectory = modeler.trajectory();
  for (std::size_t pose = 0; pose < trajectory.size(); ++pose) {
    const Line* line = line_at(trajectory[pose].stamp);
    std::vector<int> estimated(line ? line->labels.size() : 0, kNoRibbon);
    for (; ribbon != modeler.ribbons().end() && ribbon->pose == pose; ++ribbon) {
      const auto label =
          plane_of_ribbon[static_cast<std::size_t>(ribbon - modeler.ribbons().begin())];
      for (std::size_t beam = ribbon->first_beam; line && beam <= ribbon->last_beam; ++beam) {
        estimated[beam] = label;
      }
    }
    for (std::size_t beam = 0; beam < estimated.size(); ++beam) {
      const bool in_ribbon = estimated[beam] != kNoRibbon;
      if (!in_ribbon && which == Points::of_ribbons) continue;
      overlaps.add(line->labels[beam], in_ribbon ? estimated[beam] : Overlaps::kNoRegion);
    }
  }
  return overlaps;
}

/// Returns the true plane with more than half of the ribbon's points, or nullptr.
const sim::TruthPlane* PointTruth::plane_of(const Ribbon& ribbon, const Line& line) const {
  std::map<int, std::size_t> points;
  for (std::size_t beam = ribbon.first_beam; beam <= ribbon.last_beam; ++beam) {
    ++points[line.labels[beam]];
  }
  const std::size_t all = ribbon.last_beam - ribbon.first_beam + 1;
  for (const auto& [plane, count] : points) {
    if (plane != Overlaps::kNoRegion && 2 * count > all) {
      return &planes_[static_cast<std::size_t>(plane)];
    }
  }
  return nullptr;
}

std::optional<RibbonErrors> PointTruth::ribbon_errors(const Modeler& modeler) const {
  std::vector<double> angles_deg, distances_m;
  const std::vector<StampedPose> trajectory = modeler.trajectory();
  for (const Ribbon& ribbon : modeler.ribbons()) {
    const StampedPose& pose = trajectory[ribbon.pose];
    const Line* line = line_at(pose.stamp);
    const sim::TruthPlane* plane = line ? plane_of(ribbon, *line) : nullptr;
    if (!plane) continue;
    const Eigen::Vector3d normal = pose.T_map_base.linear() * ribbon.normal.cast<double>();
    const Eigen::Vector3d centroid = pose.T_map_base * ribbon.moments.mean();
    const double sine = normal.cross(plane->normal).norm();
    angles_deg.push_back(to_degrees(std::atan2(sine, normal.dot(plane->normal))));
    distances_m.push_back(std::abs(plane->normal.dot(centroid) + plane->d_m));
  }
  if (angles_deg.empty()) return std::nullopt;
  return RibbonErrors{quantile(angles_deg, 0.5), quantile(distances_m, 0.5)};
}

}  // namespace ribbon_mapper::eval
