// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "modeler/geometry/pose.hpp"

namespace ribbon_mapper {

/// Joins the trajectory of RTAB-Map from its messages: the graph has the poses without stamps, and
/// each node has its stamp and is sent once. (mapPath carries one stamp for all poses.)
class RtabmapGraph {
 public:
  /// Adds a message of rtabmap_msgs/MapData (graph and nodes) or MapGraph (the graph alone), read
  /// by its definition. Throws std::invalid_argument if it cannot be read or is neither.
  void take(const std::string& definition, const std::uint8_t* data, std::size_t size);

  /// Returns the poses of the newest graph whose stamps are known, in the order of time.
  std::vector<StampedPose> trajectory() const;

 private:
  std::map<int, Time> stamps_;  ///< of nodes
  std::map<int, Pose> poses_;   ///< of the newest graph
};

}  // namespace ribbon_mapper
