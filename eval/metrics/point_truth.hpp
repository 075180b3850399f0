// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "eval/metrics/overlaps.hpp"
#include "modeler/modeler.hpp"
#include "sim/truth/truth.hpp"

namespace ribbon_mapper::eval {

/// Medians over ribbons.
struct RibbonErrors {
  double angle_deg = 0.0;   ///< between its normal and the true one
  double distance_m = 0.0;  ///< of its centroid from the true plane
};

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

  /// How far ribbons are off the true plane that most of their points are on, as the model's
  /// trajectory places them now. Nothing if there is no such ribbon.
  std::optional<RibbonErrors> ribbon_errors(const Modeler& modeler) const;

 private:
  struct Line {
    Time middle{0};
    std::vector<int> labels;  ///< cells until settle(), then true planes; of each beam
  };
  const Line* line_at(Time middle) const;
  const sim::TruthPlane* plane_of(const Ribbon& ribbon, const Line& line) const;

  std::vector<Line> lines_;  // by time
  std::vector<sim::TruthPlane> planes_;
};

}  // namespace ribbon_mapper::eval
