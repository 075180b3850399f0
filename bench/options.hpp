// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "modeler/ros/bag/bag_lines.hpp"

namespace ribbon_mapper::bench {

/// Command line options of `bench`.
struct Options {
  bool quick = false;                              ///< part of the tour, without slow peers
  std::set<std::string> sections;                  ///< sections to run; empty for all
  std::filesystem::path output = "results/bench";  ///< folder for results and cached tours
  std::string config = "config/pr2.yaml";          ///< preset of the modeler
  std::vector<std::filesystem::path> bags;         ///< bags to measure beside the tour
  std::vector<std::string> bag_configs;  ///< presets of the bags in order; default is `config`
  BagOptions bag;                        ///< how to read the bags
  double limit_s = 600.0;                ///< CPU time after which a peer is stopped
  int repetitions = 5;                   ///< repetitions of our pipelines

  /// Returns whether a section is to run. `always` is false for sections that run only if named.
  bool asks_for(const std::string& section, bool always) const {
    return sections.empty() ? always : sections.count(section) > 0;
  }
};

}  // namespace ribbon_mapper::bench
