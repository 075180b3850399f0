// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/semantics/true_labels.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace ribbon_mapper::eval {
namespace {

constexpr double kLevelCosine = 0.9994;  // 2 degrees
constexpr double kUprightCosine = 0.5;   // leans by less than 30 degrees

/// Returns what the world says of a face, empty if it says nothing.
std::string said_of(const sim::Face& face) {
  if (!face.label.empty()) return face.label;
  if (face.name.rfind("ground_plane", 0) == 0) return "floor";
  return face.name.rfind("wall", 0) == 0 ? "wall" : "";
}

}  // namespace

Label true_label(const sim::Face& face, const Eigen::Vector3d& normal) {
  const std::string said = said_of(face);
  if (said.empty()) return normal.z() >= kLevelCosine ? Label::top : Label::furniture;
  const std::optional<Label> label = label_from(said);
  if (!label) {
    throw std::invalid_argument("The face " + face.name + " has the label \"" + said +
                                "\", which is none of floor, ceiling, wall, slope, door leaf.");
  }
  const bool is_upright = std::abs(normal.z()) < kUprightCosine;
  if (*label == Label::wall || *label == Label::door_leaf) return *label;
  if (is_upright || (*label == Label::floor && normal.z() < 0.0)) return Label::furniture;
  return *label;
}

std::vector<LabelledCell> labelled_cells(const sim::World& world,
                                         const std::vector<sim::TruthCell>& cells) {
  const std::vector<sim::Face>& faces = world.faces();
  const auto says = [](const sim::Face& face) { return !said_of(face).empty(); };
  if (std::none_of(faces.begin(), faces.end(), says)) return {};
  std::vector<LabelledCell> labelled;
  labelled.reserve(cells.size());
  for (const sim::TruthCell& cell : cells) {
    const sim::Face& face = faces[static_cast<std::size_t>(cell.face)];
    labelled.push_back({cell.centre, cell.normal, true_label(face, cell.normal)});
  }
  return labelled;
}

}  // namespace ribbon_mapper::eval
