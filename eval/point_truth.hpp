// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "eval/overlaps.hpp"
#include "modeler/modeler.hpp"
#include "sim/truth.hpp"

namespace ribbon_mapper::eval {

/// The true plane of every beam of a tour, to judge a segmentation point by point. The modeler does
/// not know of it: its ribbons are found again by the stamp of their line and their beams.
class PointTruth {
 public:
  /// `cells`: of each beam, as sim::TruthCollector::add() gives them.
  void add(Time middle_of_line, std::vector<int> cells);

  /// After the last line, before overlaps().
  void settle(const std::vector<sim::TruthPlane>& planes);

  /// Which points are judged.
  enum class Points {
    of_ribbons,  ///< what the method groups into planes
    all          ///< also the returns that no ribbon took, of the lines that are in the model
  };

  /// Points of the true planes and of the model's planes, which are those of their ribbons. Points
  /// off all true planes (legs of chairs, mixed pixels) count in the planes that took them.
  Overlaps overlaps(const Modeler& modeler, const std::vector<Plane>& planes, Points which) const;

 private:
  struct Line {
    Time middle{0};
    std::vector<int> labels;  ///< cells until settle(), then true planes; of each beam
  };
  const Line* line_at(Time middle) const;

  std::vector<Line> lines_;  // by time
  std::size_t truth_ = 0;
};

}  // namespace ribbon_mapper::eval
