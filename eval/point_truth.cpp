// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/point_truth.hpp"

#include <algorithm>
#include <utility>

namespace ribbon_mapper::eval {
namespace {

constexpr int kNoRibbon = Overlaps::no_region - 1;

/// The plane that each ribbon belongs to.
std::vector<int> ribbon_labels(std::size_t ribbons, const std::vector<Plane>& planes) {
  std::vector<int> labels(ribbons, Overlaps::no_region);
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
      if (index >= plane_of_cell.size()) plane_of_cell.resize(index + 1, Overlaps::no_region);
      plane_of_cell[index] = static_cast<int>(plane);
    }
  }
  for (Line& line : lines_) {
    for (int& label : line.labels) {
      const bool is_known = label >= 0 && static_cast<std::size_t>(label) < plane_of_cell.size();
      label = is_known ? plane_of_cell[static_cast<std::size_t>(label)] : Overlaps::no_region;
    }
  }
  truth_ = planes.size();
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
  Overlaps overlaps(truth_, planes.size());
  auto ribbon = modeler.ribbons().begin();  // they come in the order of their poses
  for (std::size_t pose = 0; pose < modeler.trajectory().size(); ++pose) {
    const Line* line = line_at(modeler.trajectory()[pose].stamp);
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
      overlaps.add(line->labels[beam], in_ribbon ? estimated[beam] : Overlaps::no_region);
    }
  }
  return overlaps;
}

}  // namespace ribbon_mapper::eval
