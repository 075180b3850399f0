// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "modeler/ros/bag/bag_set.hpp"

namespace ribbon_mapper {

/// Returns the topic of the tilting laser: `wanted`, with or without its leading slash. If `wanted`
/// is empty, returns the only topic with scans, or tilt_scan among several. Throws
/// std::runtime_error that lists the topics with scans if there is none, if the choice is not
/// clear, or if the topic carries another type.
std::string scan_topic_of(const std::vector<BagTopic>& topics, const std::string& wanted);

/// The topics with transforms.
struct TfTopics {
  std::vector<std::string> moving;  ///< /tf, with and without slash, or that of a robot
  std::vector<std::string> fixed;   ///< /tf_static, the same
  std::string note;                 ///< what was chosen, or cannot be; empty if it is /tf
};

/// Returns the topics with transforms: `wanted`, with or without its leading slash, and the
/// tf_static beside it. If `wanted` is empty, returns /tf. If the bag has no /tf, returns the only
/// topic of that name below a robot's, or that of the robot of the scans; the note says so. Throws
/// std::runtime_error that lists the topics with transforms if `wanted` is none of them.
TfTopics tf_topics_of(const std::vector<BagTopic>& topics, const std::string& wanted,
                      const std::string& scan_topic);

}  // namespace ribbon_mapper
