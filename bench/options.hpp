// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "modeler/ros/bag/bag_lines.hpp"

namespace ribbon_mapper::bench {

struct Options {
  bool quick = false;              ///< a part of the tour, and the slow peers left out
  std::set<std::string> sections;  ///< which ones; empty: all
  std::filesystem::path output = "results/bench";
  std::string config = "config/pr2.yaml";
  std::vector<std::filesystem::path> bags;  ///< recordings to measure beside the tour
  std::vector<std::string> bag_configs;     ///< their presets in this order; left out: `config`
  BagOptions bag;                           ///< how they are read
  double limit_s = 600.0;                   ///< CPU time after which a peer is stopped
  int repetitions = 5;                      ///< of our own whole pipelines

  bool asks_for(const std::string& section, bool always) const {
    return sections.empty() ? always : sections.count(section) > 0;
  }
};

}  // namespace ribbon_mapper::bench
