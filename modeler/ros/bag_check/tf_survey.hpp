// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tf2_msgs/TFMessage.h>

#include <cstddef>
#include <map>
#include <set>
#include <string>

#include "modeler/ros/bag_check/bag_report.hpp"
#include "modeler/ros/intake/line_poses.hpp"

namespace ribbon_mapper {

/// Statistics of the transforms in a bag: parents, gaps, leading slashes.
class TfSurvey {
 public:
  /// Adds the transforms of a message.
  void add(const tf2_msgs::TFMessage& message, bool is_static);

  /// Adds the findings to a report. Gaps of several `line_period_s` are warned about: motion within
  /// them is unknown.
  void report(const Frames& frames, double line_period_s, BagReport& report) const;

 private:
  struct Link {
    std::set<std::string> parents;
    std::size_t transforms = 0, backwards = 0;
    double first_s = 0.0, newest_s = 0.0, longest_gap_s = 0.0;
    bool is_static = false;
  };
  void report_links(double line_period_s, BagReport& report) const;

  std::map<std::string, Link> links_;  ///< by child
  std::size_t messages_ = 0, with_slash_ = 0;
};

}  // namespace ribbon_mapper
