// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "eval/segmentation/duplication.hpp"
#include "eval/segmentation/evops.hpp"
#include "eval/segmentation/segcomp.hpp"

namespace ribbon_mapper::eval {

/// Segmentation metrics of a model: its labels of points against the faces that the beams hit.
struct PointMetrics {
  SegComp segcomp;          ///< over the points of ribbons
  Evops evops;              ///< over the points of ribbons
  Duplication duplication;  ///< over the points of ribbons
  /// Over all returns; those outside ribbons count as missing from their planes.
  SegComp segcomp_all;
};

}  // namespace ribbon_mapper::eval
