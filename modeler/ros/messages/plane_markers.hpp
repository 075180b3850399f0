// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "modeler/io/colour.hpp"
#include "modeler/semantics/plane_label.hpp"
#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Returns the colour of a plane for viewers: grey for floors and ceilings by the rules, so that
/// all else stands out; otherwise plane_colour() with less saturation.
Colour shown_colour(const Plane& plane, Label rule);

/// Markers of the planes for rviz, which shows or hides their namespaces one by one.
///
/// "planes" and "ceilings" have a TRIANGLE_LIST for each plane, "labels" and "ceiling labels" a
/// text with id, label and area, "outlines" the boundaries of what was seen, "normals" an arrow to
/// the observed side, and "edges" the lines where planes meet. Only changes are sent, because rviz
/// rebuilds everything that it receives.
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
  using Key = std::pair<std::string, std::int32_t>;  // namespace and id

  std::map<Key, std::size_t> sent_;  ///< hash of what was sent
};

/// Returns all planes in white as one marker: the model before a correction. Deletes the marker if
/// there are no planes. Stripes between scan lines of up to `stripe_gap_m` are closed.
visualization_msgs::MarkerArray white_markers(const std::vector<Plane>& planes, double stripe_gap_m,
                                              const std_msgs::Header& header);

}  // namespace ribbon_mapper
