// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <map>
#include <vector>

#include "modeler/semantics/plane_label.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Markers of the planes for rviz: a TRIANGLE_LIST for each plane, in its colour, in the namespace
/// "planes", and a text with id, label and area in the namespace "labels". Only changes are sent,
/// because rviz rebuilds everything that it receives.
class PlaneMarkers {
 public:
  /// Returns the changes since the last call; planes that are gone are deleted. Stripes between
  /// scan lines of up to `stripe_gap_m` are closed. `labels` are those of the planes.
  visualization_msgs::MarkerArray changes(const std::vector<Plane>& planes,
                                          const std::vector<PlaneLabel>& labels,
                                          double stripe_gap_m, const std_msgs::Header& header);
  /// Makes the next call return all planes, for a new subscriber.
  void forget() { sent_.clear(); }

 private:
  std::map<std::int64_t, std::size_t> sent_;  ///< hash of what was sent
};

/// Returns all planes in white as one marker: the model before a correction. Deletes the marker if
/// there are no planes. Stripes between scan lines of up to `stripe_gap_m` are closed.
visualization_msgs::MarkerArray white_markers(const std::vector<Plane>& planes, double stripe_gap_m,
                                              const std_msgs::Header& header);

}  // namespace ribbon_mapper
