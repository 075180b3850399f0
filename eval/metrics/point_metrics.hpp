// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "eval/metrics/duplication.hpp"
#include "eval/metrics/evops.hpp"
#include "eval/metrics/segcomp.hpp"

namespace ribbon_mapper::eval {

/// How a model of planes parts the points of a tour, against the faces that its beams hit.
struct PointMetrics {
  SegComp segcomp;          ///< on the points of ribbons
  Evops evops;              ///< likewise
  Duplication duplication;  ///< likewise
  /// On all returns: a plane lacks those that no ribbon took.
  SegComp segcomp_all;
};

}  // namespace ribbon_mapper::eval
