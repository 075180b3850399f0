// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <map>
#include <vector>

#include "modeler/surface/plane.hpp"

namespace ribbon_mapper {

/// Planes for rviz: a TRIANGLE_LIST per plane, in its colour. Only what has changed is sent again,
/// for rviz rebuilds whatever it gets.
class PlaneMarkers {
 public:
  /// What has changed since the last call; planes that are gone are deleted. Stripes between scan
  /// lines of up to `stripe_gap_m` are closed.
  visualization_msgs::MarkerArray changes(const std::vector<Plane>& planes, double stripe_gap_m,
                                          const std_msgs::Header& header);
  /// The next call sends all: somebody new listens.
  void forget() { sent_.clear(); }

 private:
  std::map<std::int64_t, std::size_t> sent_;  ///< hash of what was sent
};

/// All planes in white as one marker: the model as it was before a correction. No planes: delete
/// it.
visualization_msgs::MarkerArray white_markers(const std::vector<Plane>& planes, double stripe_gap_m,
                                              const std_msgs::Header& header);

}  // namespace ribbon_mapper
