// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "eval/semantics/label_confusion.hpp"
#include "sim/truth/truth.hpp"

namespace ribbon_mapper::eval {

/// Returns what a face of the world is. `normal` points towards the laser.
///
/// The world says it by the element sim::kLabelElement: floor, ceiling, wall, slope or door leaf.
/// Shapes without it are furniture, and their level upper sides are tops. So are upright sides of
/// floors, ceilings and slopes furniture. In worlds without the element, models are known by their
/// names: ground_plane is a floor, and what begins with wall is a wall. Throws
/// std::invalid_argument with the name of a face with another label.
Label true_label(const sim::Face& face, const Eigen::Vector3d& normal);

/// Returns what a tour has seen, with labels; nothing if no face of the world says what it is.
std::vector<LabelledCell> labelled_cells(const sim::World& world,
                                         const std::vector<sim::TruthCell>& cells);

}  // namespace ribbon_mapper::eval
