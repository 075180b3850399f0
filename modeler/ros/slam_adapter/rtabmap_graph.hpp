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

/// RTAB-Map's trajectory: its graph has the poses, but no stamps; its nodes have the stamps, each
/// sent once when it is new. (Its mapPath carries one stamp for all poses.)
class RtabmapGraph {
 public:
  /// A message of rtabmap_msgs/MapData (graph and nodes) or MapGraph (the graph alone), read by its
  /// definition. Throws std::invalid_argument if it cannot be read or is neither.
  void take(const std::string& definition, const std::uint8_t* data, std::size_t size);

  /// Poses of the newest graph whose stamps are known, in order of time.
  std::vector<StampedPose> trajectory() const;

 private:
  std::map<int, Time> stamps_;  ///< of nodes
  std::map<int, Pose> poses_;   ///< of the newest graph
};

}  // namespace ribbon_mapper
