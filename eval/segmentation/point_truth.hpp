// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "eval/segmentation/overlaps.hpp"
#include "modeler/modeler.hpp"
#include "sim/truth/truth.hpp"

namespace ribbon_mapper::eval {

/// Median errors over all ribbons.
struct RibbonErrors {
  double angle_deg = 0.0;   ///< between the ribbon's normal and the true one
  double distance_m = 0.0;  ///< of the ribbon's centroid from the true plane
};

/// The true plane of every beam of a tour, for evaluating a segmentation point by point. Ribbons
/// are related to beams by the stamp of their line and their beam indices.
class PointTruth {
 public:
  /// Adds a scan line. `cells` holds the true cell of each beam, as sim::TruthCollector::add()
  /// returns it.
  void add(Time middle_of_line, std::vector<int> cells);

  /// Replaces cells by the true planes that contain them. To be called after the last line and
  /// before overlaps().
  void settle(const std::vector<sim::TruthPlane>& planes);

  /// Selects the points to evaluate.
  enum class Points {
    of_ribbons,  ///< the points of ribbons, which the method groups into planes
    all          ///< all returns of the lines in the model
  };

  /// Counts the points that true planes share with `planes` of the modeler. Points off all true
  /// planes (chair legs, mixed pixels) count only for the planes that contain them.
  Overlaps overlaps(const Modeler& modeler, const std::vector<Plane>& planes, Points which) const;

  /// Returns the median errors of ribbons at their current poses, against the true plane with most
  /// of their points. Returns nothing if no ribbon lies on a true plane.
  std::optional<RibbonErrors> ribbon_errors(const Modeler& modeler) const;

 private:
  struct Line {
    Time middle{0};
    std::vector<int> labels;  ///< by beam: cells until settle(), then true planes
  };
  const Line* line_at(Time middle) const;
  const sim::TruthPlane* plane_of(const Ribbon& ribbon, const Line& line) const;

  std::vector<Line> lines_;  // by time
  std::vector<sim::TruthPlane> planes_;
};

}  // namespace ribbon_mapper::eval
