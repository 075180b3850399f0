// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "modeler/semantics/semantics.hpp"

namespace ribbon_mapper::eval {

/// A cell of 5 cm of the world that a beam hit, and what it is.
struct LabelledCell {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< in map [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< towards the laser
  Label label = Label::furniture;                     ///< the truth
};

/// True labels against those of the model, by area.
struct LabelConfusion {
  /// Area of the model's cells [m2]: first index the true label, second the model's, in the order
  /// of kLabels.
  std::array<std::array<double, kLabels.size()>, kLabels.size()> area_m2 = {};
  double no_truth_m2 = 0.0;  ///< area of the model's cells where no beam hit a face like that

  /// Returns the area of cells with this true label that the model gives that label [m2].
  double at(Label truth, Label model) const;
  /// Returns the area of all cells with a true label [m2].
  double compared_m2() const;
  /// Returns the share of this area whose label is right; 1 if there is none.
  double right_share() const;
  /// Adds another matrix.
  void add(const LabelConfusion& other);
};

/// Compares the labels of a model's cells with those of the nearest true cells within 10 cm whose
/// normals differ by less than 25 degrees. `labels` are those of the planes, in their order.
LabelConfusion label_confusion(const std::vector<Plane>& planes,
                               const std::vector<Decision>& labels,
                               const std::vector<LabelledCell>& truth);

}  // namespace ribbon_mapper::eval
